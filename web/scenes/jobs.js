// SPDX-License-Identifier: MIT
// The jobs of the guides, live: each makes a small model anew with the package, as the guide says.
import { remesh, repair } from 'remesher';
import { beforeAfter } from './before_after.js';
import { generated, overlapping, plate, scan } from './made.js';
import { bumpyTorus } from './solid.js';

/** @typedef {import('remesher').MeshReport} MeshReport */
/** @typedef {import('./before_after.js').Made} Made */

const count = (/** @type {number} */ value) => value.toLocaleString('en');
const off = (/** @type {number} */ percent) => `${percent.toPrecision(2)} % of the diagonal`;

/** @param {number} faces @returns {Promise<Made>} */
export async function lighter(faces) {
  const { mesh, report } = await remesh(scan(), { faces, prefer: 'shape' });
  const { input, output, fidelity } = report;
  return { polygons: mesh, words: `${count(input.triangles)} triangles became `
    + `${count(output.triangles)}, at most ${off(fidelity.hausdorff)} from where they were.` };
}

/** @returns {Promise<Made>} */
export async function printable() {
  const { mesh, report: { input, output, repair: done } } =
    await repair(overlapping(), { repair: 'auto' });
  const [before, after] = done?.selfIntersections ?? [0, 0];
  return { polygons: mesh, words: `Open edges: ${input.boundaryEdges} before, `
    + `${output.boundaryEdges} after. Triangles that intersect others: ${before} before, ${after} `
    + 'after.' };
}

/** @param {number} edgeLength @returns {Promise<Made>} */
export async function simulated(edgeLength) {
  const { mesh, report: { input, output } } =
    await remesh(plate(), { preset: 'simulation', edgeLength });
  return { polygons: mesh, words: `Smallest angle: ${input.minAngle.worst.toFixed(1)}° before, `
    + `${output.minAngle.worst.toFixed(1)}° after, ${output.minAngle.mean.toFixed(0)}° on average; `
    + `${count(output.triangles)} triangles.` };
}

/** Points of a line that winds round the torus. @param {number} turns round its tube */
function winding(turns) {
  return Array.from({ length: 97 }, (_, i) => {
    const [u, v] = [2 * Math.PI * i / 96, 2 * Math.PI * turns * i / 96];
    const ring = 0.78 + 0.34 * Math.cos(v);
    return [ring * Math.cos(u), ring * Math.sin(u), 0.34 * Math.sin(v)];
  });
}

/** @param {number} vertices @param {number} turns 0: no guide @returns {Promise<Made>} */
export async function quads(vertices, turns) {
  const kind = /** @type {const} */ ('direction');
  const guides = turns ? [{ points: winding(turns), kind }] : [];
  const { mesh, report: { output } } = await remesh(bumpyTorus(), { quads: true, vertices, guides,
    symmetry: turns ? 'off' : 'auto' });
  const { count: all = 0, irregular = 0, angleDeviation } = output.quads ?? {};
  return { polygons: mesh, words: `${count(all)} quads, ${irregular} irregular vertices, angles `
    + `${angleDeviation?.mean.toFixed(1)}° from 90° on average.` };
}

/** @param {number} faces @returns {Promise<Made>} */
export async function cleaned(faces) {
  const { mesh, report: { input, output } } = await remesh(generated(),
    { faces, repair: 'auto', dropBelow: 'auto', prefer: 'shape' });
  return { polygons: mesh, words: `${input.components} pieces and `
    + `${count(input.triangles)} triangles `
    + `became ${output.components} with ${count(output.triangles)}.` };
}

/** @type {Record<string, (figure: HTMLElement) => void>} */
export const jobs = {
  lighter: (figure) => beforeAfter(figure, { before: scan(),
    sliders: [{ name: 'Triangles', min: 200, max: 6000, step: 100, value: 1000 }],
    make: ([faces]) => lighter(faces) }),
  printing: (figure) => beforeAfter(figure, { before: overlapping(), sliders: [], make: printable,
    tilt: 2.4, isOpen: true }),
  simulation: (figure) => beforeAfter(figure, { before: plate(),
    sliders: [{ name: 'Edge length', min: 0.06, max: 0.3, step: 0.02, value: 0.12 }],
    make: ([edgeLength]) => simulated(edgeLength) }),
  quads: (figure) => beforeAfter(figure, { before: bumpyTorus(),
    sliders: [{ name: 'Vertices', min: 200, max: 2000, step: 100, value: 700 },
      { name: 'Turns of a guide', min: 0, max: 6, step: 1, value: 0 }],
    make: ([vertices, turns]) => quads(vertices, turns) }),
  generated: (figure) => beforeAfter(figure, { before: generated(),
    sliders: [{ name: 'Triangles', min: 200, max: 4000, step: 100, value: 1000 }],
    make: ([faces]) => cleaned(faces) }),
};
