// SPDX-License-Identifier: MIT
// Repairs broken surfaces and remeshes the results. The native judge checks the promises. Where
// CGAL is on the machine, it checks them again; with --wrap its alpha wrap is beside. Sheets must
// stay as they are, and become closed bodies of a thickness. Where bodies meet at angles narrower
// than the limit, a number of vertices keeps the shape; with minAngle no angle is below that limit.
// Seconds are the processor's.
import { writeFileSync } from 'node:fs';
import { remesh, repair } from 'remesher';

import { askewBoxes, cracked, doubledScan, looseTriangles, manyBodies, moebiusStrip, nestedBoxes,
  thinHouse, tJunctions } from '../support/broken_shapes.js';
import { torus, sheet } from '../support/shapes.js';
import { judge } from './judge.js';
import { loadModel } from './models.js';
import { alphaWrap, wrongByCgal } from './repair_peers.js';
import { percentFound, seenSharpEdges } from './sharp_edges.js';
import { fixed, markdownTable } from './table.js';

// Distances are those from the input to the result, and back. Back, the far side of a thin solid
// made of a sheet counts; from the input, parts within bodies do.
const columns = ['model', 'mode', 'triangles', 's', 'open', 'crossing', 'RMS %', '→ vertices',
  'open', 'crossing', 'worst °', 'flat', 'RMS %', 's', 'CGAL', 'edges %',
  'wrap: triangles', 's', 'RMS %'];

/** Two meshes as one, the second scaled and moved along x. */
function joined(a, b, scale, by) {
  const moved = Array.from(b.positions, (value, i) => scale * value + (i % 3 === 0 ? by : 0));
  return {
    positions: Float64Array.from([...a.positions, ...moved]),
    indices: Uint32Array.from([...a.indices,
      ...Array.from(b.indices, (v) => v + a.positions.length / 3)]),
  };
}

/** The mesh without every `every`-th triangle. */
const torn = ({ positions, indices }, every) => ({ positions,
  indices: indices.filter((_, i) => Math.floor(i / 3) % every !== 0) });

/** The mesh with every other triangle turned over. */
const turned = ({ positions, indices }) => ({ positions,
  indices: indices.map((_, i, all) => (Math.floor(i / 3) % 2 === 0 || i % 3 === 0
    ? all[i] : all[i % 3 === 1 ? i + 1 : i - 1])) });

/** Surfaces by formula. */
const made = {
  shell: () => joined(torus(), torus(), 0.98, 0),
  crossed: () => joined(torus(), torus(), 1, 0.9),
  apart: () => joined(torus(), torus(), 1, 20),
  torn: () => torn(torus(), 37),
  turned: () => turned(torus()),
  sheet: () => sheet(),
  scan: () => doubledScan({ columns: 260, rows: 125 }),
  cracked: () => cracked({ columns: 200, rows: 100 }),
  junctions: tJunctions,
  moebius: () => moebiusStrip(),
  loose: () => looseTriangles(100000, 0.03),
  nested: () => nestedBoxes(),
  house: () => thinHouse(),
  bodies: () => manyBodies(),
  askew: askewBoxes,
};

/** The broken promises of a repaired surface. */
function brokenPromises(name, result) {
  return ['boundaryEdges', 'nonManifoldEdges', 'selfIntersections', 'degenerateTriangles']
    .filter((fault) => result[fault] > 0)
    .map((fault) => `${name}: ${result[fault]} ${fault}`);
}

/** Whether a sheet comes back as it was, and that is said. */
function isLeftAlone(given, { mesh, report }) {
  const said = report.warnings.some(({ code }) => ['SHEETS_LEFT', 'ONE_SIDED'].includes(code));
  const isSame = ['positions', 'indices'].every((list) => mesh[list].length === given[list].length
    && mesh[list].every((value, i) => value === given[list][i]));
  return said && isSame;
}

/** The seconds that the processor takes for it. @param {() => Promise<any>} act */
async function timed(act) {
  const begin = process.cpuUsage();
  const result = await act();
  const { user, system } = process.cpuUsage(begin);
  return { ...result, seconds: (user + system) / 1e6 };
}

/** Alpha wrap's result on the mesh, judged. */
function wrapped(given) {
  const wrap = alphaWrap(given);
  return wrap && { seconds: wrap.seconds, ...judge(given, wrap.mesh) };
}

/** The percentages of the given mesh's sharp edges that results have. */
function edgesFound(given, results) {
  const seen = seenSharpEdges(given);
  return results.map((result) => percentFound(seen, result));
}

async function measured(name, row, how) {
  const { model = name, mode = 'auto', vertices = 5000, edges, thickness } = row;
  const given = made[model]?.() ?? loadModel(model, how.folder);
  const options = { repair: mode, thickness, worker: false };
  const mended = await timed(() => repair(given, options));
  const after = await timed(() => remesh(given, { ...options, vertices }));
  const angled = row.minAngle
    ? await remesh(given, { repair: mode, minAngle: row.minAngle, worker: false }) : undefined;
  const alone = thickness ? await repair(given, { repair: mode, worker: false }) : undefined;
  return { name, mode: mended.report.repair.mode, seconds: mended.seconds,
    isChanged: alone && !isLeftAlone(given, alone), mended: judge(given, mended.mesh),
    remeshSeconds: after.seconds, remeshed: judge(given, after.mesh),
    angled: angled && judge(given, angled.mesh),
    wrong: [mended, after, angled].filter(Boolean).map(({ mesh }) => wrongByCgal(mesh)),
    edges: edges ? edgesFound(given, [mended.mesh, after.mesh]) : undefined,
    wrap: how.wrap ? wrapped(given) : undefined };
}

const bothWays = (fidelity) => fidelity
  && `${fixed(fidelity.rmsToResult, 4)} / ${fixed(fidelity.rmsToOriginal, 4)}`;

function rowOf({ name, mode, seconds, mended, remeshSeconds, remeshed, wrong, edges,
  wrap }) {
  const [one, two] = [mended.result, remeshed.result];
  return [name, mode, one.triangles, fixed(seconds, 2), one.boundaryEdges, one.selfIntersections,
    bothWays(mended.fidelity), two.vertices, two.boundaryEdges,
    two.selfIntersections, fixed(two.worstAngle, 1), two.degenerateTriangles,
    bothWays(remeshed.fidelity), fixed(remeshSeconds, 2),
    wrong[0] && (wrong.flat().join(', ') || 'sound'),
    edges?.map((share) => fixed(share, 1)).join(' → '), wrap?.result.triangles,
    fixed(wrap?.seconds, 2), bothWays(wrap?.fidelity)];
}

/** @param {any} limits
 * @param {{ folder?: string, names: string[], json?: string }} how */
export async function runRepair(limits, { folder, names, json, wrap }) {
  const all = [];
  const broken = [];
  for (const [name, row] of Object.entries(limits)) {
    if (names.length > 0 && !names.some((word) => name.startsWith(word))) continue;
    if (row.model && !folder) continue;
    const found = await measured(name, row, { folder, wrap });
    all.push(found);
    broken.push(...brokenPromises(`${name}, repaired`, found.mended.result),
      ...brokenPromises(`${name}, remeshed`, found.remeshed.result),
      ...found.wrong.flatMap((words = []) => words.map((word) => `${name}, by CGAL: ${word}`)));
    if (found.isChanged) broken.push(`${name}: a sheet is changed`);
    if (found.seconds > row.seconds) broken.push(`${name}: ${found.seconds.toFixed(2)} s`);
    for (const { fidelity } of [found.mended, found.remeshed, found.angled].filter(Boolean)) {
      if (fidelity.rmsToOriginal > row.rms) broken.push(`${name}: RMS ${fidelity.rmsToOriginal} %`);
    }
    if (found.edges?.[0] < row.edges) broken.push(`${name}: edges ${found.edges[0].toFixed(1)} %`);
    if (found.angled) broken.push(...brokenPromises(`${name}, angled`, found.angled.result));
    for (const [{ result }, least] of [[found.remeshed, row.worstAngle],
      ...found.angled ? [[found.angled, row.minAngle]] : []]) {
      if (result.worstAngle < least) {
        broken.push(`${name}: an angle of ${result.worstAngle.toFixed(1)}°`);
      }
    }
  }
  if (json) writeFileSync(json, `${JSON.stringify(all, null, 2)}\n`);
  return { table: markdownTable(columns, all.map(rowOf)), broken };
}
