// SPDX-License-Identifier: MIT
// The worker that holds the surfaces, and answers questions that take longer than a frame.
import { irregularVertices } from './irregular.js';
import { linesOf } from './lines.js';
import { offVertices } from './off.js';
import { pick } from './picking.js';
import { ringOf } from './ring.js';
import { strokesOf } from './strokes.js';
import { measureDistances, Surface } from './surface.js';

/** @typedef {import('../triangles/soup.js').Soup} Soup */
/** @typedef {import('./surface.js').Point} Point */
/** @typedef {import('./surface.js').Distances} Distances */
/** @typedef {'original' | 'baseline' | 'result'} Side */

/** @type {Partial<Record<Side, Surface>>} */
const surfaces = {};

/** The questions, by name. */
const questions = {
  /** @param {{ side: Side, soup: Soup | null }} request soup: null removes the surface */
  setSurface({ side, soup }) {
    if (soup?.indices.length) surfaces[side] = new Surface(soup);
    else delete surfaces[side];
    return null;
  },
  /** @param {import('remesher').EdgeSummary} found on the original */
  lines: (found) => (surfaces.original ? linesOf(surfaces.original.soup, found) : null),
  /** @param {{ side: Side, first: Uint32Array }} request first: see EdgeSummary */
  irregular: ({ side, first }) => (surfaces[side]
    ? irregularVertices(surfaces[side].soup, first) : null),
  /** @param {Side} side */
  strokes: (side) => (surfaces[side] ? strokesOf(surfaces[side].soup) : null),
  /** @param {{ known: number | null, isRepair: boolean }} how known: the largest distance, in model
   *   units, if it is @returns {Distances | null} */
  distances: (how) => (surfaces.result && surfaces.original
    ? measureDistances(surfaces.result, surfaces.original, how) : null),
  /** @param {{ side: Side, origin: Point, direction: Point }} request */
  pick({ side, origin, direction }) {
    const on = surfaces[side];
    const against = side === 'original' ? null : surfaces.original ?? null;
    return on ? pick({ on, against, origin, direction }) : null;
  },
  /** @param {{ side: Side, point: Point, wished: Point }} request */
  viewOf: ({ side, point, wished }) => surfaces[side]?.viewOf(point, wished) ?? wished,
  /** @param {{ through: Point, normal: Point }} plane that cuts the original */
  ring: (plane) => (surfaces.original ? ringOf(surfaces.original.soup, plane) : null),
  offVertices,
};

/** @typedef {typeof questions} Questions */

addEventListener('message', ({ data: { number, question, request } }) => {
  try {
    const answer = questions[/** @type {'pick'} */ (question)](request);
    postMessage({ number, answer });
  } catch (error) {
    postMessage({ number, error: String(error) });
  }
});
