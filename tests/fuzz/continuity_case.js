// SPDX-License-Identifier: MIT
// Cases of the law "continuity": a sound or open surface, at ten neighbouring numbers of vertices.
import { remesh } from 'remesher';

import { lawsOfErrors } from '../support/laws.js';
import { lawsOfNeighbours } from '../support/trust/smooth.js';
import { Dice } from './dice.js';
import { openSheet, soundBody } from './made_bodies.js';

const neighbours = 10;

/** @param {number} seed */
export function makeContinuityCase(seed) {
  const dice = new Dice(seed);
  const { name, shape } = dice.pick([soundBody, soundBody, openSheet])(dice);
  const first = Math.round(Math.max(30, Math.min(400,
    shape.positions.length * dice.pick([0.5, 1, 1, 2, 3]))) * dice.number(0.97, 1));
  const apart = dice.pick([1, 1, Math.max(1, Math.round(0.01 * first))]);
  const options = dice.pick([{}, {}, { quads: true }, { prefer: 'shape' }]);
  return { description: name, options, mesh: { positions: Float64Array.from(shape.positions.flat()),
    indices: Uint32Array.from(shape.triangles.flat()) },
  counts: Array.from({ length: neighbours }, (_, i) => first + i * apart) };
}

/** The broken laws. @param {ReturnType<typeof makeContinuityCase>} input @param {object} [how] */
export async function runContinuityCase({ mesh, counts, options }, how = {}) {
  const runs = [];
  try {
    for (const vertices of counts) {
      const { report } = await remesh(mesh, { ...options, vertices, ...how });
      runs.push({ asked: vertices, report });
    }
  } catch (error) {
    if (error?.name === 'AbortError') return { broken: ['it does not end'], size: 0 };
    return { broken: lawsOfErrors(error), size: 0, code: error.code };
  }
  return { broken: lawsOfNeighbours(runs), size: counts[0] };
}
