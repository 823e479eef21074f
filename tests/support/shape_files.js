// SPDX-License-Identifier: MIT
// Generated shapes, as files of common formats.

/** A torus of m × n vertices, its triangles all alike along a ring. */
export function torus(m, n) {
  const positions = [];
  const triangles = [];
  for (let i = 0; i < m; ++i) {
    for (let j = 0; j < n; ++j) {
      const [u, v] = [2 * Math.PI * i / m, 2 * Math.PI * j / n];
      const radius = 2 + 0.8 * Math.cos(v);
      positions.push([radius * Math.cos(u), 0.8 * Math.sin(v), -radius * Math.sin(u)]);
      const at = (k, l) => ((i + k) % m) * n + (j + l) % n;
      triangles.push([at(0, 0), at(1, 0), at(1, 1)], [at(0, 0), at(1, 1), at(0, 1)]);
    }
  }
  return { positions, triangles };
}

export function objText({ positions, triangles }) {
  const vertices = positions.map((p) => `v ${p.join(' ')}`);
  const faces = triangles.map((t) => `f ${t.map((index) => index + 1).join(' ')}`);
  return [...vertices, ...faces, ''].join('\n');
}

/** A glTF's JSON and its only buffer, separately. */
export function gltfParts({ positions, triangles }) {
  const points = new Float32Array(positions.flat());
  const indices = new Uint32Array(triangles.flat());
  const extreme = (pick) =>
    [0, 1, 2].map((axis) => pick(...positions.map((p) => Math.fround(p[axis]))));
  const buffer = Buffer.concat([Buffer.from(points.buffer), Buffer.from(indices.buffer)]);
  const json = {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
    buffers: [{ byteLength: buffer.length }],
    bufferViews: [
      { buffer: 0, byteLength: points.byteLength },
      { buffer: 0, byteOffset: points.byteLength, byteLength: indices.byteLength },
    ],
    accessors: [
      { bufferView: 0, componentType: 5126, type: 'VEC3', count: positions.length,
        min: extreme(Math.min), max: extreme(Math.max) },
      { bufferView: 1, componentType: 5125, type: 'SCALAR', count: indices.length },
    ],
  };
  return { json, buffer };
}

export function glbBytes(mesh) {
  const { json, buffer } = gltfParts(mesh);
  const text = JSON.stringify(json);
  const padded = Buffer.from(text.padEnd(Math.ceil(text.length / 4) * 4));
  const header = (...words) => Buffer.from(Uint32Array.from(words).buffer);
  return Buffer.concat([
    header(0x46546c67, 2, 28 + padded.length + buffer.length), header(padded.length, 0x4e4f534a),
    padded, header(buffer.length, 0x004e4942), buffer,
  ]);
}
