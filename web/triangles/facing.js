// SPDX-License-Identifier: MIT
// The direction an open surface faces: a mask should be seen from outside.
import { Vector3 } from 'three';
import { breath } from '../base/breath.js';

/** Corners between two pauses. */
const portion = 300_000;

/** A closed surface's area vectors sum to zero. A surface counts as closed if their sum is below
 * this share of its area. */
const leastShare = 0.2;

/** The direction that the surfaces together face, null if they count as closed.
 * @param {import('./soup.js').Soup} soup */
export async function openSide({ positions: p, indices }) {
  const sum = new Vector3();
  let area = 0;
  for (let i = 0; i < indices.length; i += 3) {
    if (i % portion === 0) await breath();
    const [a, b, c] = [3 * indices[i], 3 * indices[i + 1], 3 * indices[i + 2]];
    const ux = p[b] - p[a], uy = p[b + 1] - p[a + 1], uz = p[b + 2] - p[a + 2];
    const vx = p[c] - p[a], vy = p[c + 1] - p[a + 1], vz = p[c + 2] - p[a + 2];
    const x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
    sum.x += x;
    sum.y += y;
    sum.z += z;
    area += Math.hypot(x, y, z);
  }
  return sum.length() > leastShare * area ? sum.normalize() : null;
}
