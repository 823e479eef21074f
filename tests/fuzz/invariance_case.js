// SPDX-License-Identifier: MIT
// The law "invariance": where a model lies, how large it is, how it is turned, in which order its
// vertices and triangles are written, the output's format and the thread change nothing: the same
// mesh up to the file's rounding.
import { surfaceOf } from '../support/independent/surface.js';
import { differences } from '../support/trust/same.js';
import { lawsOfErrors } from '../support/laws.js';
import { Dice } from './dice.js';
import { faultyBody, openSheet, soundBody } from './made_bodies.js';
import { runOf } from './trust_case.js';
import { objFile } from './trust_files.js';

/** Multiples of this are moved by whole numbers and scaled by powers of two without rounding. */
const step = 2 ** -20;
/** Decimals have so many digits, in files that people write. */
const digits = 6;

const fitted = ({ positions, triangles }, rounded) => {
  const size = positions.flat().reduce((large, x) => Math.max(large, Math.abs(x)), 0);
  const factor = 2 ** -Math.ceil(Math.log2(size));
  return { triangles, positions: positions.map((p) =>
    p.map((x) => rounded(x * factor))) };
};

const mapped = ({ positions, triangles }, map) => ({ positions: positions.map(map), triangles });

function shuffled(list, dice) {
  const all = [...list];
  for (let i = all.length - 1; i > 0; i -= 1) {
    const k = dice.whole(0, i);
    [all[i], all[k]] = [all[k], all[i]];
  }
  return all;
}

const reordered = ({ positions, triangles }, dice) => {
  const order = shuffled(positions.keys(), dice);
  const numbers = new Map(order.map((v, i) => [v, i]));
  return { positions: order.map((v) => positions[v]),
    triangles: triangles.map((t) => t.map((v) => numbers.get(v))) };
};

const inSteps = (/** @type {number} */ x) => Math.round(x / step) * step;
const inDecimals = (/** @type {number} */ x) => Number(x.toFixed(digits));

/** The decimal, its point moved. */
const shifted = (/** @type {number} */ x, /** @type {number} */ places) =>
  Number(`${Math.round(x * 10 ** digits)}e${places - digits}`);

const scaledBy = (/** @type {number} */ factor) => ({ words: `by ${factor}`,
  shape: (shape) => mapped(shape, (p) => p.map((x) => x * factor)), undo: (x) => x / factor });

/** Share of the diagonal to which coordinates are rounded: those of single precision, in binary
 * formats. Doubles in text are much finer, at ten million diagonals too. */
const rounding = 1e-5;

const turnInWords = 'x to y to z';

/** A change: of the shape, and how it is undone in the result; or another output or thread.
 * @type {Record<string, (dice: Dice) => any>} */
export const changes = {
  moved: (dice) => {
    const by = [0, 1, 2].map(() => Math.round(dice.number(-1, 1) * 2 ** dice.whole(1, 24)));
    return { words: `by ${by}`, shape: (shape) => mapped(shape, (p) => p.map((x, k) => x + by[k])),
      undo: (x, k) => x - by[k] };
  },
  scaled: (dice) => scaledBy(2 ** dice.whole(-40, 40)),
  'moved in decimals': (dice) => {
    const by = [0, 1, 2].map(() => inDecimals(dice.number(-1, 1) * 10 ** dice.whole(0, 6)));
    return { words: `by ${by}`, rounded: inDecimals, undo: (x, k) => x - by[k],
      shape: (shape) => mapped(shape, (p) => p.map((x, k) => inDecimals(x + by[k]))) };
  },
  'scaled by tens': (dice) => {
    const places = dice.whole(-6, 6);
    return { words: `by 1e${places}`, rounded: inDecimals, undo: (x) => x / 10 ** places,
      shape: (shape) => mapped(shape, (p) => p.map((x) => shifted(x, places))) };
  },
  turned: () => ({ words: turnInWords, shape: (shape) => mapped(shape, ([x, y, z]) => [z, x, y]),
    undo: (_, k, p) => p[(k + 1) % 3] }),
  'in another order of vertices': (dice) => ({ shape: (shape) => reordered(shape, dice) }),
  'in another order of triangles': (dice) => ({ shape: ({ positions, triangles }) => ({ positions,
    triangles: shuffled(triangles, dice).map(([a, b, c]) =>
      dice.pick([[a, b, c], [b, c, a], [c, a, b]])) }) }),
  'in another format': (dice) => ({ output: dice.pick(['stl', 'ply', 'off', 'glb']) }),
  'on this thread': () => ({ how: { worker: false } }),
};

/** @param {number} seed */
export function makeInvarianceCase(seed) {
  const dice = new Dice(seed);
  const { name, shape } = dice.pick([soundBody, soundBody, openSheet, faultyBody])(dice);
  const kind = dice.pick(Object.keys(changes));
  const change = changes[kind](dice);
  const vertices = Math.round(Math.max(20, Math.min(600, shape.positions.length)));
  const options = dice.pick([{ vertices }, { vertices }, { vertices, quads: true },
    { repair: 'auto' }]);
  return { description: `${name} ${kind} ${change.words ?? change.output ?? ''}`,
    shape: fitted(shape, change.rounded ?? inSteps), change, options };
}

function undone(surface, { undo = (x) => x }) {
  return { ...surface, positions: surface.positions.map((x, i) => {
    const p = surface.positions.subarray(i - (i % 3), i - (i % 3) + 3);
    return undo(x, i % 3, p);
  }) };
}

/** A run's result, or its error. */
async function resultOf(shape, options, { output = 'obj', how }) {
  const isRepair = !('vertices' in options);
  try {
    const { read, report } = await runOf({ description: '', isRepair, options, output,
      file: objFile(shape.positions, shape.triangles) }, how);
    return { surface: surfaceOf(read.parts), report };
  } catch (error) {
    if (error?.name === 'AbortError' || lawsOfErrors(error).length > 0) throw error;
    return { code: error.code };
  }
}

const figures = (/** @type {any} */ { output, repair }) => [`${output.components} components`,
  `${output.boundaryEdges} open edges`, repair ? `repair ${repair.mode}` : ''].join(', ');

/** The broken laws. @param {ReturnType<typeof makeInvarianceCase>} input @param {object} [how] */
export async function runInvarianceCase({ shape, change, options }, how = {}) {
  try {
    const plain = await resultOf(shape, options, { how });
    const changed = await resultOf(change.shape?.(shape) ?? shape, options,
      { output: change.output, how: { ...how, ...change.how } });
    if (plain.code || changed.code) {
      return { broken: plain.code === changed.code ? []
        : [`${plain.code ?? 'done'} before, ${changed.code ?? 'done'} after`], size: 0 };
    }
    let broken = differences(plain.surface, undone(changed.surface, change), rounding);
    // A surface that is turned onto itself has no axes of its own, and gets the same mesh.
    const isSymmetric = broken.length > 0 && change.words === turnInWords
      && differences(plain.surface, changed.surface, rounding).length === 0;
    if (isSymmetric) broken = [];
    const said = [figures(plain.report), figures(changed.report)];
    if (said[0] !== said[1]) broken.push(`${said[0]} before, ${said[1]} after`);
    return { broken, size: plain.report.output.vertices };
  } catch (error) {
    if (error?.name === 'AbortError') return { broken: ['it does not end'], size: 0 };
    return { broken: lawsOfErrors(error), size: 0, code: error.code };
  }
}
