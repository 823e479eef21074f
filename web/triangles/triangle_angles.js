// SPDX-License-Identifier: MIT
// Colours faces by quality: a triangle by its smallest angle, a quad by the largest deviation of
// its angles from 90°, other polygons by the deviation from a regular polygon's angles.
import { BufferAttribute, Color } from 'three';
import { angleColors } from '../base/colors.js';
import { cornersOfPolygon } from './polygons.js';

const palette = angleColors.map((color) => new Color(color));

/** The smallest angle of a triangle in degrees, from its squared edge lengths.
 * @param {number} a @param {number} b @param {number} c */
function smallestAngle(a, b, c) {
  const [shortest, middle, longest] = [a, b, c].sort((x, y) => x - y);
  const cosine = (middle + longest - shortest) / (2 * Math.sqrt(middle * longest));
  return Math.acos(Math.min(1, cosine)) * 180 / Math.PI || 0;
}

/** @param {ArrayLike<number>} p @param {number} i @param {number} j */
function squaredDistance(p, i, j) {
  const x = p[3 * i] - p[3 * j], y = p[3 * i + 1] - p[3 * j + 1], z = p[3 * i + 2] - p[3 * j + 2];
  return x * x + y * y + z * z;
}

/** The smallest angle of the triangle with these corners, in degrees.
 * @param {ArrayLike<number>} p @param {number[]} corners */
const ofTriangle = (p, [a, b, c]) => smallestAngle(squaredDistance(p, a, b),
  squaredDistance(p, b, c), squaredDistance(p, c, a));

/** The largest deviation of a polygon's angles from those of a regular polygon, in degrees.
 * @param {ArrayLike<number>} p @param {number[]} corners */
function largestDeviation(p, corners) {
  const count = corners.length;
  const regular = 180 - 360 / count;
  let largest = 0;
  for (let i = 0; i < count; ++i) {
    const [a, b, c] = [corners[(i + count - 1) % count], corners[i], corners[(i + 1) % count]];
    const left = squaredDistance(p, a, b), right = squaredDistance(p, b, c);
    const cosine = (left + right - squaredDistance(p, a, c)) / (2 * Math.sqrt(left * right) || 1);
    const angle = Math.acos(Math.max(-1, Math.min(1, cosine))) * 180 / Math.PI;
    largest = Math.max(largest, Math.abs(angle - regular));
  }
  return largest;
}

/** The face's quality in steps of ten degrees: 0 is the worst.
 * @param {ArrayLike<number>} p @param {number[]} corners */
const stepOf = (p, corners) => (corners.length === 3
  ? Math.min(5, Math.floor(ofTriangle(p, corners) / 10))
  : 5 - Math.min(5, Math.floor(largestDeviation(p, corners) / 10)));

/** Colours every face of a geometry without an index.
 * @param {import('three').BufferGeometry} geometry
 * @param {import('./polygons.js').Polygons | null} polygons null: triangles */
export function colorByAngle(geometry, polygons) {
  const positions = geometry.getAttribute('position').array;
  const colors = new Float32Array(positions.length);
  const faces = polygons ? polygons.length - 1 : positions.length / 9;
  for (let face = 0; face < faces; ++face) {
    const [first, end] = polygons ? [polygons[face], polygons[face + 1]] : [face, face + 1];
    const color = palette[stepOf(positions, cornersOfPolygon(first, end))];
    for (let corner = 3 * first; corner < 3 * end; ++corner) color.toArray(colors, 3 * corner);
  }
  geometry.setAttribute('color', new BufferAttribute(colors, 3));
}
