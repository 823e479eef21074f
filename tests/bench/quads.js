// SPDX-License-Identifier: MIT
// Quads of named models, judged by a separate evaluator that takes any mesh of quads.
import { judge } from './judge.js';
import { loadModel } from './models.js';
import { timeRemesh } from './run.js';
import { fixed, markdownTable } from './table.js';

const columns = ['model', 'vertices', 'irregular', 'mean °', 'p95 °', 'Jacobian ≥', 'Hausdorff %',
  'ripple %', 's'];

const minus = (a, b) => a.map((x, i) => x - b[i]);
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
const cross = ([a, b, c], [d, e, f]) => [b * f - c * e, c * d - a * f, a * e - b * d];
const norm = (a) => Math.sqrt(dot(a, a));

/** For each corner of a quad: its angle in degrees, and its sine along the quad's normal. */
function cornersOf(points) {
  const normal = cross(minus(points[2], points[0]), minus(points[3], points[1]));
  const size = norm(normal) || 1;
  return points.map((p, i) => {
    const [out, back] = [minus(points[(i + 1) % 4], p), minus(points[(i + 3) % 4], p)];
    const area = cross(out, back);
    const lengths = norm(out) * norm(back) || 1;
    return {
      angle: Math.atan2(norm(area), dot(out, back)) * (180 / Math.PI),
      sine: dot(area, normal) / size / lengths,
    };
  });
}

/** Number of inner vertices whose valence is not 4. */
function countIrregular(quads) {
  const sides = new Map();
  for (let i = 0; i < quads.length; i += 1) {
    const [a, b] = [quads[i], quads[i % 4 === 3 ? i - 3 : i + 1]];
    const edge = a < b ? `${a} ${b}` : `${b} ${a}`;
    sides.set(edge, (sides.get(edge) ?? 0) + 1);
  }
  const valence = new Map();
  const open = new Set();
  for (const [edge, count] of sides) {
    for (const v of edge.split(' ')) {
      valence.set(v, (valence.get(v) ?? 0) + 1);
      if (count !== 2) open.add(v);
    }
  }
  return [...valence].filter(([v, count]) => !open.has(v) && count !== 4).length;
}

/** For each directed edge, as `from to`, the vertex that follows `to` in its quad. */
function nextCorners(quads) {
  const next = new Map();
  for (let i = 0; i < quads.length; i += 1) {
    const corner = (k) => quads[i - (i % 4) + ((i + k) % 4)];
    next.set(`${corner(0)} ${corner(1)}`, corner(2));
  }
  return next;
}

/**
 * How wavy the rows of quads are: the root mean square of fourth differences along rows through
 * regular inner vertices, in percent of an edge. Subdivided quads show as stripes what this sees.
 * @param {{ positions: ArrayLike<number>, quads: ArrayLike<number> }} mesh
 */
export function ripple({ positions, quads }) {
  const place = (v) => [positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]];
  const next = nextCorners(quads);
  const valence = new Map();
  for (const edge of next.keys()) {
    const [from] = edge.split(' ').map(Number);
    valence.set(from, (valence.get(from) ?? 0) + 1);
  }
  // The vertex that the row from a through b comes to, if b is regular.
  const onward = (a, b) => {
    if (valence.get(b) !== 4 || !next.has(`${b} ${a}`)) return undefined;
    const beside = next.get(`${a} ${b}`);
    return next.has(`${beside} ${b}`) ? next.get(`${beside} ${b}`) : undefined;
  };
  let [sum, count] = [0, 0];
  for (const edge of next.keys()) {
    const [v, a] = edge.split(' ').map(Number);
    const b = onward(a, v);
    const [c, d] = b === undefined ? [] : [onward(v, a), onward(v, b)];
    if (c === undefined || d === undefined) continue;
    const points = [d, b, v, a, c].map(place);
    const fourth = [0, 1, 2].map((k) => points[0][k] - 4 * points[1][k] + 6 * points[2][k] -
      4 * points[3][k] + points[4][k]);
    const side = (norm(minus(points[1], points[2])) + norm(minus(points[3], points[2]))) / 2;
    if (side === 0) continue;
    sum += dot(fourth, fourth) / side ** 2;
    count += 1;
  }
  return count > 0 ? 100 * Math.sqrt(sum / count) : 0;
}

/** @param {{ positions: ArrayLike<number>, quads: ArrayLike<number> }} mesh */
export function evaluate({ positions, quads }) {
  const place = (v) => [positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]];
  const deviations = [];
  let jacobian = 1;
  for (let i = 0; i < quads.length; i += 4) {
    for (const { angle, sine } of cornersOf([0, 1, 2, 3].map((k) => place(quads[i + k])))) {
      deviations.push(Math.abs(angle - 90));
      jacobian = Math.min(jacobian, sine);
    }
  }
  deviations.sort((a, b) => a - b);
  return {
    irregular: countIrregular(quads),
    mean: deviations.reduce((sum, x) => sum + x, 0) / deviations.length,
    p95: deviations[Math.floor(0.95 * (deviations.length - 1))],
    jacobian,
    ripple: ripple({ positions, quads }),
  };
}

function brokenLimits(found, row, { original, result }) {
  const broken = [];
  const most = (name, value) => {
    if (value > row[name]) broken.push(`${name} ${value.toFixed(3)}, not ${row[name]}`);
  };
  for (const name of ['irregular', 'mean', 'p95', 'hausdorff', 'ripple']) most(name, found[name]);
  if (found.jacobian < row.jacobian) broken.push(`Jacobian ${found.jacobian}, not ${row.jacobian}`);
  if (Math.abs(result.vertices / row.vertices - 1) > 0.01) {
    broken.push(`${result.vertices} vertices, not about ${row.vertices}`);
  }
  for (const name of ['components', 'boundaryLoops', 'nonManifoldEdges', 'eulerCharacteristic']) {
    if (result[name] !== original[name]) broken.push(`${name} ${result[name]}`);
  }
  return broken;
}

export async function runQuads(limits, { folder, names }) {
  if (!folder) throw new Error('quads needs the folder of the models.');
  const rows = [];
  const broken = [];
  for (const [name, row] of Object.entries(limits)) {
    if (names.length > 0 && !names.some((word) => name.startsWith(word))) continue;
    const model = loadModel(row.model, folder);
    const { mesh, seconds } = await timeRemesh(model, { quads: true, vertices: row.vertices }, 1);
    const judgement = judge(model, mesh);
    const found = { ...evaluate(mesh), hausdorff: judgement.fidelity.hausdorff };
    broken.push(...brokenLimits(found, row, judgement).map((line) => `${name}: ${line}`));
    rows.push([name, judgement.result.vertices, found.irregular, fixed(found.mean, 1),
      fixed(found.p95, 1), fixed(found.jacobian, 2), fixed(found.hausdorff, 2),
      fixed(found.ripple, 0), fixed(seconds, 1)]);
  }
  return { table: markdownTable(columns, rows), broken };
}
