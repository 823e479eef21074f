// SPDX-License-Identifier: MIT
// Other programs that make a mesh of about so many vertices, those of them that are on the machine.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

import { MeshoptSimplifier } from 'meshoptimizer';

import { offText } from '../support/shapes.js';
import { cgalProgram, folders } from './cgal.js';
import { readOff } from './models.js';

/** @typedef {{ positions: Float64Array, indices: Uint32Array }} Mesh */
/** @typedef {{ mesh: Mesh, seconds: number }} Made */

/** So often a length is tried anew until the number is met. */
const tries = 5;

function sizeOf({ positions, indices }) {
  const at = (v) => positions.subarray(3 * v, 3 * v + 3);
  let area = 0;
  const [low, high] = [[0, 1, 2].map(() => Infinity), [0, 1, 2].map(() => -Infinity)];
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => at(indices[i + k]));
    const [u, v] = [b, c].map((p) => [0, 1, 2].map((k) => p[k] - a[k]));
    area += Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
      u[0] * v[1] - u[1] * v[0]) / 2;
    for (const k of [0, 1, 2]) {
      low[k] = Math.min(low[k], a[k]);
      high[k] = Math.max(high[k], a[k]);
    }
  }
  return { area, diagonal: Math.hypot(...high.map((x, k) => x - low[k])) };
}

/** A program's work on files, by its clock. @param {(folder: string) => void} act */
function timed(mesh, act) {
  const folder = mkdtempSync(join(tmpdir(), 'remesher-peer-'));
  try {
    const start = performance.now();
    const made = act(folder);
    return { mesh: made, seconds: (performance.now() - start) / 1000 };
  } catch {
    return undefined;
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** The run whose number is nearest, each try with a length that the one before suggests: vertices
 * go with its power. @param {(length: number) => Made | undefined} run */
function nearest(run, { vertices, length, power }) {
  let best;
  for (let k = 0, next = length; k < tries; k += 1) {
    const made = run(next);
    if (!made) return best;
    const off = Math.log(made.mesh.positions.length / 3 / vertices);
    if (!best || Math.abs(off) < Math.abs(best.off)) best = { ...made, off };
    if (Math.abs(off) < 0.01) break;
    next *= Math.exp(off / power);
  }
  return best;
}

/** Text of Medit's format, which mmgs reads. */
function meditText({ positions, indices }) {
  const rows = (list, shift) => Array.from({ length: list.length / 3 }, (_, i) =>
    `${Array.from(list.subarray(3 * i, 3 * i + 3), (x) => x + shift).join(' ')} 0`);
  return ['MeshVersionFormatted 2', 'Dimension 3', 'Vertices', positions.length / 3,
    ...rows(positions, 0), 'Triangles', indices.length / 3, ...rows(indices, 1), 'End'].join('\n');
}

/** @returns {Mesh} */
function readMedit(text) {
  const words = text.split(/\s+/);
  const block = (name) => {
    const first = words.indexOf(name) + 2;
    const count = Number(words[first - 1]);
    return Array.from({ length: 3 * count }, (_, i) =>
      Number(words[first + 4 * Math.floor(i / 3) + (i % 3)]));
  };
  return { positions: Float64Array.from(block('Vertices')),
    indices: Uint32Array.from(block('Triangles'), (v) => v - 1) };
}

const mmgsProgram = folders('PATH').flatMap((folder) =>
  ['mmgs_O3', 'mmgs'].map((name) => join(folder, name))).find(existsSync);

/** By the distance that it may be away, which is what it is good at.
 * @param {Mesh} mesh @param {number} vertices */
function mmgs(mesh, vertices) {
  if (!mmgsProgram) return undefined;
  const { area, diagonal } = sizeOf(mesh);
  const longest = 2 * Math.sqrt((2 / Math.sqrt(3)) * (area / vertices));
  return nearest((distance) => timed(mesh, (folder) => {
    const [model, result] = ['model.mesh', 'result.mesh'].map((name) => join(folder, name));
    writeFileSync(model, meditText(mesh));
    execFileSync(mmgsProgram, ['-v', '0', '-ar', '40', '-hausd', String(distance),
      '-hmax', String(longest), model, result], { stdio: 'ignore' });
    return readMedit(readFileSync(result, 'utf8'));
  }), { vertices, length: 0.001 * diagonal, power: 0.5 });
}

/** @param {Mesh} mesh @param {number} vertices */
function cgal(mesh, vertices) {
  const program = cgalProgram('cgal_main.cpp');
  if (!program) return undefined;
  const length = Math.sqrt((2 / Math.sqrt(3)) * (sizeOf(mesh).area / vertices));
  return nearest((edge) => timed(mesh, (folder) => {
    const [model, result] = ['model.off', 'result.off'].map((name) => join(folder, name));
    writeFileSync(model, offText(mesh));
    execFileSync(program, [model, String(edge), result], { stdio: 'ignore' });
    return readOff(readFileSync(result, 'utf8'));
  }), { vertices, length, power: 2 });
}

/** It only takes away. @param {Mesh} mesh @param {number} triangles */
export async function meshoptimizer({ positions, indices }, triangles) {
  if (3 * triangles >= indices.length) return undefined;
  await MeshoptSimplifier.ready;
  const start = performance.now();
  const [left] = MeshoptSimplifier.simplify(indices, Float32Array.from(positions), 3,
    3 * triangles, 1);
  const seconds = (performance.now() - start) / 1000;
  const names = new Map();
  const corners = Uint32Array.from(left, (v) => {
    if (!names.has(v)) names.set(v, names.size);
    return names.get(v);
  });
  const places = [...names.keys()].flatMap((v) => [...positions.subarray(3 * v, 3 * v + 3)]);
  return { mesh: { positions: Float64Array.from(places), indices: corners }, seconds };
}

/** Each makes a mesh of about so many vertices, or says that it cannot. */
export const peers = { mmgs, 'CGAL, sharp edges': cgal };
