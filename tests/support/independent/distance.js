// SPDX-License-Identifier: MIT
// Two-sided distance between surfaces, from samples: a lower bound of the true distance.
import { BoxTree } from './box_tree.js';
import { cornersOf } from './surface.js';

/** Points of each triangle: corners, and a grid within of about `perTriangle` points. */
function* samples(corners, perTriangle) {
  const steps = Math.max(1, Math.round(Math.sqrt(2 * perTriangle)));
  for (let at = 0; at < corners.length; at += 9) {
    for (let i = 0; i <= steps; i += 1) {
      for (let k = 0; k <= steps - i; k += 1) {
        const [u, v] = [i / steps, k / steps];
        yield [0, 1, 2].map((x) => (1 - u - v) * corners[at + x] + u * corners[at + 3 + x]
          + v * corners[at + 6 + x]);
      }
    }
  }
}

function oneSided(from, to, perTriangle) {
  const tree = new BoxTree(to);
  let largest = { distance: 0, at: /** @type {number[]} */ ([]) };
  for (const p of samples(from, perTriangle)) {
    const distance = tree.distance(p);
    if (distance > largest.distance) largest = { distance, at: p };
  }
  return largest;
}

/**
 * The largest sampled distance, with its place, in each direction.
 * @param {import('./surface.js').Surface} one @param {import('./surface.js').Surface} other
 */
export function distances(one, other, samplesInAll = 20000) {
  const [a, b] = [cornersOf(one), cornersOf(other)];
  const share = (corners) => Math.min(200, Math.max(1, 9 * samplesInAll / corners.length));
  return { there: oneSided(a, b, share(a)), back: oneSided(b, a, share(b)) };
}
