// SPDX-License-Identifier: MIT
// The worker that finds the triangles of a very large model that are drawn.
import { fewerTriangles } from './fewer_triangles.js';

addEventListener('message', async ({ data }) => {
  try {
    const fewer = await fewerTriangles(data);
    const buffers = [fewer.corners.buffer, fewer.drawn.buffer,
      ...(fewer.normals ? [fewer.normals.buffer] : [])];
    postMessage({ fewer }, { transfer: buffers });
  } catch (error) {
    postMessage({ error: String(error) });
  }
});
