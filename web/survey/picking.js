// SPDX-License-Identifier: MIT
// The face that a ray hits, a triangle or a polygon, with its angles, its edge lengths and the
// distance of its corners from another surface.
import { Vector3 } from 'three';
import { cornersOfPolygon } from '../triangles/polygons.js';

/** @typedef {import('./surface.js').Surface} Surface */
/** @typedef {import('./surface.js').Point} Point */
/**
 * lengths[i]: of the edge after corners[i]; angles[i]: at corners[i], in degrees; distance: the
 * largest of the corners, null without another surface.
 * @typedef {{ triangle: number, point: Point, corners: Point[], angles: number[],
 *   lengths: number[], distance: number | null }} Pick
 */

/** @param {Vector3[]} corners the angle at each, in degrees */
function anglesOf(corners) {
  return corners.map((corner, i) => {
    const next = corners[(i + 1) % corners.length].clone().sub(corner);
    const last = corners[(i + corners.length - 1) % corners.length].clone().sub(corner);
    return next.angleTo(last) * 180 / Math.PI;
  });
}

/** The corners of the face with this triangle. @param {Surface['soup']} soup
 * @param {number} triangle */
function cornersOfFace({ positions, indices, polygons }, triangle) {
  const k = polygons ? polygons.findLastIndex((first) => first <= triangle) : 0;
  const corners = polygons ? cornersOfPolygon(polygons[k], polygons[k + 1])
    : cornersOfPolygon(triangle, triangle + 1);
  return corners.map((corner) => new Vector3().fromArray(positions, 3 * indices[corner]));
}

/** @param {{ on: Surface, against: Surface | null, origin: Point, direction: Point }} request
 * @returns {Pick | null} */
export function pick({ on, against, origin, direction }) {
  const hit = on.hit(origin, direction);
  if (!hit || typeof hit.faceIndex !== 'number') return null;
  const corners = cornersOfFace(on.soup, hit.faceIndex);
  const lengths = corners.map((corner, i) =>
    corner.distanceTo(corners[(i + 1) % corners.length]));
  return {
    triangle: hit.faceIndex,
    point: hit.point.toArray(),
    corners: corners.map((corner) => corner.toArray()),
    angles: anglesOf(corners),
    lengths,
    distance: against && Math.max(...corners.map((corner) => against.distanceTo(corner))),
  };
}
