// SPDX-License-Identifier: MIT
// The smallest angle of each triangle as the triangle's colour.
import { BufferAttribute, Color } from 'three';
import { angleColors } from '../base/colors.js';

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

/** Colours every triangle of a geometry without an index.
 * @param {import('three').BufferGeometry} geometry */
export function colorByAngle(geometry) {
  const positions = geometry.getAttribute('position').array;
  const colors = new Float32Array(positions.length);
  for (let v = 0; v < positions.length / 3; v += 3) {
    const angle = smallestAngle(squaredDistance(positions, v, v + 1),
      squaredDistance(positions, v + 1, v + 2), squaredDistance(positions, v + 2, v));
    const color = palette[Math.min(5, Math.floor(angle / 10))];
    for (let corner = v; corner < v + 3; ++corner) color.toArray(colors, 3 * corner);
  }
  geometry.setAttribute('color', new BufferAttribute(colors, 3));
}
