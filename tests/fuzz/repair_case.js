// SPDX-License-Identifier: MIT
// The laws of repair, for any surface: the repaired surface, and its remeshed surface, are closed,
// face outwards and do not intersect themselves. Edges of four triangles are left only where closed
// bodies of the input touch; what is remeshed there may intersect, which a warning counts. Sheets
// stay as they are.
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
const exact = ['sound', 'closed', 'united'];

/** @param {any} mesh @param {string} what
 * @param {{ mayTouch: boolean, crossings?: number }} allowed crossings: as a warning counts */
async function lawsOfMended(mesh, what, { mayTouch, crossings = 0 }) {
  const { input, faults } = await inspect(mesh, { faults: true });
  const broken = [];
  for (const name of mayTouch ? ['boundaryEdges'] : ['boundaryEdges', 'nonManifoldEdges']) {
    if (input[name] > 0) broken.push(`${what}: ${input[name]} ${name}`);
  }
  if (faults.insideOut > 0) broken.push(`${what}: ${faults.insideOut} insideOut`);
  if (faults.selfIntersections > crossings) {
    broken.push(`${what}: ${faults.selfIntersections} selfIntersections, ${crossings} reported`);
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
    const broken = await lawsOfMended(mended.mesh, 'repaired', { mayTouch });
    const remeshed = await remesh(mesh, { ...options, vertices: count, ...how });
    const warning = remeshed.report.warnings.find(({ code }) => code === 'SELF_INTERSECTIONS_MADE');
    broken.push(...await lawsOfMended(remeshed.mesh, 'remeshed',
      { mayTouch, crossings: mayTouch ? warning?.count : 0 }));
    return { broken, size: mended.report.output.vertices };
  } catch (error) {
    if (error?.name === 'AbortError') return { broken: ['it does not end'], size: 0 };
    return { broken: lawsOfErrors(error), size: 0, code: error.code };
  }
}
