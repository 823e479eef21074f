// SPDX-License-Identifier: MIT
// Models that quads are tried on: machine parts with several parameters, bodies of thin parts,
// figures of several bodies, and all files below the folders that are given.
import { readFileSync, readdirSync, statSync } from 'node:fs';
import { basename, extname, join } from 'node:path';

import { convertFile } from 'remesher';
import { BoxGeometry, CapsuleGeometry, ConeGeometry, CylinderGeometry, ExtrudeGeometry,
  IcosahedronGeometry, LatheGeometry, Matrix4, Shape, TorusKnotGeometry, Vector2 } from 'three';
import { mergeGeometries, mergeVertices } from 'three/addons/utils/BufferGeometryUtils.js';

import { engraved, filletedPlate, gear, plate, sheetMetal, thread }
  from '../support/machine_parts.js';
import { signetRing, torus } from '../support/shapes.js';
import { loadModel, readOff } from './models.js';

/** Places and corners of geometries, each moved and turned by its matrix, equal places welded.
 * @param {...any} geometries */
function meshOf(...geometries) {
  const bare = geometries.map((geometry) => {
    const copy = geometry.clone();
    copy.deleteAttribute('normal');
    copy.deleteAttribute('uv');
    return mergeVertices(copy, 1e-5);
  });
  const { attributes, index } = mergeGeometries(bare);
  const indices = [];
  for (let i = 0; i < index.count; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => index.getX(i + k));
    if (a !== b && b !== c && c !== a) indices.push(a, b, c);
  }
  return { positions: Float64Array.from(attributes.position.array),
    indices: Uint32Array.from(indices) };
}

/** @param {any} geometry @param {number[]} place @param {number} [turn] about z */
const at = (geometry, place, turn = 0) => geometry
  .applyMatrix4(new Matrix4().makeRotationZ(turn).setPosition(place[0], place[1], place[2]));

function extruded(points, holes, depth) {
  const shape = new Shape(points.map(([x, y]) => new Vector2(x, y)));
  for (const [x, y, radius] of holes) {
    const hole = new Shape();
    hole.absarc(x, y, radius, 0, 2 * Math.PI, true);
    shape.holes.push(hole);
  }
  return meshOf(new ExtrudeGeometry(shape, { depth, bevelEnabled: false, curveSegments: 12 }));
}

const bracket = () => extruded([[0, 0], [60, 0], [60, 12], [12, 12], [12, 50], [0, 50]],
  [[6, 44, 3], [48, 6, 3], [30, 6, 1.5]], 20);

/** A plate with a grid of round holes. */
const perforated = () => extruded([[0, 0], [80, 0], [80, 50], [0, 50]],
  Array.from({ length: 15 }, (_, i) => [10 + 15 * (i % 5), 10 + 15 * Math.floor(i / 5), 4]), 5);

/** Two rails on a foot whose inner sides lean by 45°. */
const dovetail = () => extruded([[0, 0], [60, 0], [60, 30], [45, 30], [33, 18], [27, 18],
  [15, 30], [0, 30]], [], 40);

const vase = () => meshOf(new LatheGeometry([[0, 0], [4, 0], [6, 5], [3, 11], [4, 14], [3.6, 14],
  [2.6, 11], [5.5, 5], [3.6, 0.5], [0, 0.5]].map(([x, y]) => new Vector2(x, y)), 40));

/** A ball with spikes all over, each thinner than a quad of a thousand at its tip. */
function spiky() {
  const ball = meshOf(new IcosahedronGeometry(1, 24));
  const tips = meshOf(new IcosahedronGeometry(1, 0)).positions;
  for (let i = 0; i < ball.positions.length; i += 3) {
    const place = ball.positions.subarray(i, i + 3);
    let rise = 0;
    for (let k = 0; k < tips.length; k += 3) {
      const near = place[0] * tips[k] + place[1] * tips[k + 1] + place[2] * tips[k + 2];
      rise = Math.max(rise, Math.exp(-120 * (1 - near)));
    }
    place.forEach((x, k) => { ball.positions[i + k] = x * (1 + 1.2 * rise); });
  }
  return ball;
}

/** A ball with two ears as thin as leaves. */
function eared() {
  const ball = meshOf(new IcosahedronGeometry(1, 24));
  for (let i = 0; i < ball.positions.length; i += 3) {
    const [x, y, z] = ball.positions.subarray(i, i + 3);
    const near = Math.exp(-90 * y * y) * Math.exp(-30 * (Math.abs(x) - 0.6) ** 2);
    const rise = z > 0 ? 1.4 * near : 0;
    ball.positions.set([x * (1 + 0.4 * rise), y, z * (1 + rise)], i);
  }
  return ball;
}

const conesAround = () => meshOf(new IcosahedronGeometry(1, 12),
  ...Array.from({ length: 10 }, (_, i) => at(new ConeGeometry(0.03, 0.08, 12),
    [1.3 * Math.cos(0.63 * i), 1.3 * Math.sin(0.63 * i), 0.2])));

/** A figure: trunk, head, limbs of two bodies each, buttons. */
const mannequin = () => meshOf(new CapsuleGeometry(0.5, 1, 12, 32),
  at(new IcosahedronGeometry(0.45, 8), [0, 1.6, 0]),
  ...[-1, 1].flatMap((side) => [
    at(new CapsuleGeometry(0.14, 0.6, 6, 16), [0.8 * side, 0.5, 0], 0.5 * side),
    at(new CapsuleGeometry(0.12, 0.6, 6, 16), [1.1 * side, -0.3, 0], 0.2 * side),
    at(new CapsuleGeometry(0.18, 0.6, 6, 16), [0.3 * side, -1.5, 0]),
    at(new CapsuleGeometry(0.15, 0.6, 6, 16), [0.3 * side, -2.4, 0]),
    at(new BoxGeometry(0.3, 0.15, 0.6), [0.3 * side, -2.95, 0.12])]),
  ...Array.from({ length: 4 }, (_, i) =>
    at(new CylinderGeometry(0.05, 0.05, 0.03, 12), [0, 0.5 - 0.3 * i, 0.56])));

const stool = () => meshOf(at(new CylinderGeometry(1, 1, 0.15, 48), [0, 1, 0]),
  ...Array.from({ length: 3 }, (_, i) => at(new CylinderGeometry(0.08, 0.06, 1.8, 20),
    [0.7 * Math.cos(2.1 * i), 0, 0.7 * Math.sin(2.1 * i)])));

/** Those after the plain machine parts have never been tuned to. */
export const madeModels = {
  plate, filletedPlate, gear, engraved, sheetMetal, thread: () => thread(), bracket, perforated,
  vase, spiky, mannequin, conesAround,
  'gear of 11': () => gear({ teeth: 11 }), 'gear of 30': () => gear({ teeth: 30 }),
  'thread of 3': () => thread({ turns: 3, steps: 32 }), dovetail, eared, stool, signetRing,
  torus: () => torus(), knot: () => meshOf(new TorusKnotGeometry(1, 0.25, 160, 24)),
};

const formats = new Set(['.obj', '.stl', '.ply', '.off', '.glb']);

/** Files of more bytes take minutes and say nothing that smaller ones do not. */
const mostBytes = 4e6;

function filesBelow(folder) {
  return readdirSync(folder, { withFileTypes: true })
    .sort((a, b) => (a.name < b.name ? -1 : 1))
    .flatMap((entry) => {
      const path = join(folder, entry.name);
      if (entry.isDirectory()) return entry.name === 'broken' ? [] : filesBelow(path);
      const isModel = formats.has(extname(path).toLowerCase());
      return isModel && statSync(path).size <= mostBytes ? [path] : [];
    });
}

async function fromFile(path) {
  const { bytes } = await convertFile(readFileSync(path), { name: basename(path), output: 'off' });
  return readOff(new TextDecoder().decode(bytes));
}

/** What makes or reads each model, by name. @param {string[]} folders
 * @returns {Map<string, () => any>} */
export function quadModels(folders) {
  const files = folders.flatMap(filesBelow).map((path) =>
    /** @type {[string, () => any]} */ ([basename(path, extname(path)), () => fromFile(path)]));
  return new Map([...files, ['npm bunny', () => loadModel('npm:bunny', undefined)],
    ['npm teapot', () => loadModel('npm:teapot', undefined)], ...Object.entries(madeModels)]);
}
