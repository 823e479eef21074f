// SPDX-License-Identifier: MIT
// The triangle that a ray hits, with its angles, its edges and how far its corners are from another
// surface.
import { Vector3 } from 'three';

/** @typedef {import('./surface.js').Surface} Surface */
/** @typedef {import('./surface.js').Point} Point */
/**
 * lengths[i] of the edge opposite to corners[i], angles[i] in degrees there; distance: the largest
 * of the corners', null without another surface.
 * @typedef {{ triangle: number, point: Point, corners: Point[], angles: number[],
 *   lengths: number[], distance: number | null }} Pick
 */

/** @param {number[]} lengths the angle opposite to each, in degrees */
function anglesOf(lengths) {
  return lengths.map((a, i) => {
    const [b, c] = [lengths[(i + 1) % 3], lengths[(i + 2) % 3]];
    const cosine = (b * b + c * c - a * a) / (2 * b * c || 1);
    return Math.acos(Math.max(-1, Math.min(1, cosine))) * 180 / Math.PI;
  });
}

/** @param {{ on: Surface, against: Surface | null, origin: Point, direction: Point }} request
 * @returns {Pick | null} */
export function pick({ on, against, origin, direction }) {
  const hit = on.hit(origin, direction);
  if (!hit || typeof hit.faceIndex !== 'number') return null;
  const { positions, indices } = on.soup;
  const first = 3 * hit.faceIndex;
  const corners = [0, 1, 2].map((k) =>
    new Vector3().fromArray(positions, 3 * indices[first + k]));
  const lengths = corners.map((_, i) =>
    corners[(i + 1) % 3].distanceTo(corners[(i + 2) % 3]));
  return {
    triangle: hit.faceIndex,
    point: hit.point.toArray(),
    corners: corners.map((corner) => corner.toArray()),
    angles: anglesOf(lengths),
    lengths,
    distance: against && Math.max(...corners.map((corner) => against.distanceTo(corner))),
  };
}
