// SPDX-License-Identifier: MIT
// Models as plain arrays: OBJ and OFF files of a folder, or models from npm packages ("npm:name",
// "npm:name/part").
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { runInNewContext } from 'node:vm';

const require = createRequire(import.meta.url);

/** @param {number[][]} points @param {number[][]} polygons */
function fromLists(points, polygons) {
  const triangles = polygons.flatMap((polygon) => polygon.slice(2)
    .map((corner, k) => [polygon[0], polygon[k + 1], corner]));
  return { positions: new Float64Array(points.flat()), indices: new Uint32Array(triangles.flat()) };
}

function readObj(text) {
  const points = [];
  const polygons = [];
  for (const line of text.split('\n')) {
    const [word, ...rest] = line.trim().split(/\s+/);
    if (word === 'v') points.push(rest.slice(0, 3).map(Number));
    if (word !== 'f') continue;
    polygons.push(rest.map((corner) => {
      const number = parseInt(corner, 10);
      return number < 0 ? points.length + number : number - 1;
    }));
  }
  return fromLists(points, polygons);
}

/** @param {string} text */
export function readOff(text) {
  const lines = text.replace(/#.*$/gm, '').split('\n').map((line) => line.trim()).filter(Boolean);
  const [pointCount, polygonCount] = lines[1].split(/\s+/).map(Number);
  const numbers = (line) => line.split(/\s+/).map(Number);
  // Normals, colours and texture coordinates may follow the place.
  const points = lines.slice(2, 2 + pointCount).map((line) => numbers(line).slice(0, 3));
  const polygons = lines.slice(2 + pointCount, 2 + pointCount + polygonCount).map(numbers);
  return fromLists(points, polygons.map(([size, ...corners]) => corners.slice(0, size)));
}

// Runs a module that imports nothing, without require(): require() would keep the module's million
// small lists, and every garbage collection during a timed run would visit all of them.
function exportsOf(path) {
  const exports = {};
  runInNewContext(readFileSync(path, 'utf8'), { exports });
  return exports;
}

/** @param {string} name @param {string | undefined} folder */
export function loadModel(name, folder) {
  if (name.startsWith('npm:')) {
    const { positions, cells } = exportsOf(require.resolve(name.slice('npm:'.length)));
    return fromLists(positions, cells);
  }
  if (!folder) return undefined;
  const text = readFileSync(join(folder, name), 'utf8');
  return name.endsWith('.off') ? readOff(text) : readObj(text);
}

/** @param {{ positions: ArrayLike<number>, indices: ArrayLike<number> }} mesh */
export function toObj({ positions, indices }) {
  const lines = [];
  for (let i = 0; i < positions.length; i += 3) {
    lines.push(`v ${positions[i]} ${positions[i + 1]} ${positions[i + 2]}`);
  }
  for (let i = 0; i < indices.length; i += 3) {
    lines.push(`f ${indices[i] + 1} ${indices[i + 1] + 1} ${indices[i + 2] + 1}`);
  }
  return `${lines.join('\n')}\n`;
}
