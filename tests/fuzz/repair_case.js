// SPDX-License-Identifier: MIT
// The laws of repair, for any surface: the repaired surface, and its remeshed surface, are closed,
// face outwards and do not intersect themselves. Edges of four triangles are left only where closed
// bodies of the input touch; what is remeshed there may intersect, which a warning counts. Sheets
// stay as they are, also among bodies, where a warning says so. How many vertices the surface gets
// afterwards does not decide whether it is one.
import { inspect, remesh, repair } from 'remesher';

import { lawsOfErrors } from '../support/laws.js';
import { Dice } from './dice.js';
import { meshOf } from './made_files.js';
import { shapes } from './made_shapes.js';
import { spoilShape } from './mutations.js';

/**
 * @param {number} seed
 * @returns {{ description: string, mesh: any, options: any, count: number }}
 */
export function makeRepairCase(seed) {
  const dice = new Dice(seed);
  const name = dice.pick(Object.keys(shapes));
  const said = [name];
  let shape = shapes[name](dice.whole(1, 4));
  for (let times = dice.whole(0, 3); times > 0; times -= 1) shape = spoilShape(shape, dice, said);
  const options = { repair: dice.pick(['solid', 'wrap', 'auto']) };
  return { description: said.join(', '), mesh: meshOf(shape), options,
    count: dice.whole(100, 1500) };
}

/** The reasons of repairs that keep the input's own triangles. */
const exact = ['sound', 'joined', 'closed', 'united'];

/** The count of a warning that names a place, else 0.
 * @param {any[]} warnings @param {string} name */
const named = (warnings, name) =>
  warnings.find(({ code, at }) => code === name && at !== undefined)?.count ?? 0;

/**
 * The laws that a repaired mesh breaks. Sheets, surfaces of one side and intersections that auto
 * leaves between bodies break none if a warning says where they are.
 * @param {any} mesh @param {string} what
 * @param {{ mayTouch: boolean, warnings?: any[], crossings?: number }} allowed crossings: besides
 * those that were left
 */
export async function lawsOfMended(mesh, what, { mayTouch, warnings = [], crossings = 0 }) {
  const { input, faults } = await inspect(mesh, { faults: true });
  const broken = [];
  const left = named(warnings, 'SHEETS_LEFT') + named(warnings, 'ONE_SIDED');
  if (input.boundaryEdges > 0 && left === 0) {
    broken.push(`${what}: ${input.boundaryEdges} boundaryEdges`);
  }
  if (input.nonManifoldEdges > 0 && !mayTouch) {
    broken.push(`${what}: ${input.nonManifoldEdges} nonManifoldEdges`);
  }
  if (faults.insideOut > 0) broken.push(`${what}: ${faults.insideOut} insideOut`);
  const reported = crossings + named(warnings, 'CROSSINGS_LEFT');
  if (faults.selfIntersections > reported) {
    broken.push(`${what}: ${faults.selfIntersections} selfIntersections, ${reported} reported`);
  }
  return broken;
}

/**
 * The broken laws.
 * @param {ReturnType<typeof makeRepairCase>} input
 * @param {object} [how] of the call: signal, worker
 * @returns {Promise<{ broken: string[], size: number, code?: string }>}
 */
export async function runRepairCase({ mesh, options, count }, how = {}) {
  try {
    const mended = await repair(mesh, { ...options, ...how });
    const { reason } = mended.report.repair;
    if (reason === 'sheets') {
      const isSame = mended.mesh.indices.length === mesh.indices.length;
      return { broken: isSame ? [] : ['sheets are changed'], size: mended.report.output.vertices };
    }
    const mayTouch = exact.includes(reason) || options.repair === 'solid';
    const broken = await lawsOfMended(mended.mesh, 'repaired',
      { mayTouch, warnings: mended.report.warnings });
    const remeshed = await remesh(mesh, { ...options, vertices: count, ...how });
    if (remeshed.report.repair.reason === 'sheets') {
      return { broken: ['sheets only if it is remeshed'], size: mended.report.output.vertices };
    }
    const { warnings } = remeshed.report;
    const crossings = mayTouch ? named(warnings, 'SELF_INTERSECTIONS_MADE') : 0;
    broken.push(...await lawsOfMended(remeshed.mesh, 'remeshed',
      { mayTouch, warnings, crossings }));
    return { broken, size: mended.report.output.vertices };
  } catch (error) {
    if (error?.name === 'AbortError') return { broken: ['it does not end'], size: 0 };
    return { broken: lawsOfErrors(error), size: 0, code: error.code };
  }
}
