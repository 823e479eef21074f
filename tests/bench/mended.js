// SPDX-License-Identifier: MIT
// What repair makes of broken files: the families of tests/support/broken_files.js, and all models
// below the folders that are given. The native engine repairs; the written bytes are judged by the
// reader of tests/support/independent. Files are not tuned to: only the families have limits.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, dirname, extname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

import { brokenFiles } from '../support/broken_files.js';
import { isSound } from '../support/independent/bodies.js';
import { BoxTree } from '../support/independent/box_tree.js';
import { figuresOf } from '../support/independent/figures.js';
import { readFile } from '../support/independent/read.js';
import { cornersOf, diagonalOf, trianglePlaces } from '../support/independent/surface.js';
import { toObj } from './models.js';
import { fixed, markdownTable } from './table.js';

const tool = join(dirname(fileURLToPath(import.meta.url)), '../../build/native/mended');
const formats = new Set(['.obj', '.stl', '.ply', '.off', '.glb', '.gltf']);

/** Larger files and results say nothing that smaller ones do not, and take minutes. */
const mostBytes = 8e6, mostTriangles = 1e5, mostSeconds = 90;

/** Of larger results only the numbers are known, which take the reader seconds. */
const mostJudged = 4e4;

const columns = ['file', 'triangles', '→', '×', 's', 'way', 'lattice', 'open', 'not manifold',
  'crossing', 'sound', 'kept %', 'seen lost %', 'said'];

/** What a triangle is by its corners, wherever it starts. */
function keyOf(surface, t) {
  const places = trianglePlaces(surface, t).map((p) => [...p].join());
  const first = places.indexOf([...places].sort()[0]);
  return [0, 1, 2].map((k) => places[(first + k) % 3]).join(' ');
}

/** Percent of the given triangles that are written bit for bit. */
function percentKept(given, written) {
  const keys = (surface) => Array.from({ length: surface.triangles.length / 3 },
    (_, t) => keyOf(surface, t));
  const all = new Set(keys(written)), own = keys(given);
  return own.length > 0 ? (100 * own.filter((key) => all.has(key)).length) / own.length : 100;
}

const directions = Array.from({ length: 24 }, (_, i) => {
  const [height, turn] = [1 - (2 * i + 1) / 24, 2.399963229728653 * i + 0.1];
  const radius = Math.sqrt(1 - height * height);
  return [radius * Math.cos(turn), radius * Math.sin(turn), height];
});

/** A distance in the diagonal from which on a point is lost. */
const lostBeyond = 0.002;

/** Percent of the points that are seen from outside, which the written surface is away from. */
function percentLost(given, written, wanted = 600) {
  const diagonal = diagonalOf(given);
  const [tree, other] = [given, written].map((surface) => new BoxTree(cornersOf(surface)));
  const count = given.triangles.length / 3;
  if (count === 0 || written.triangles.length === 0) return count === 0 ? 0 : 100;
  let [seen, lost] = [0, 0];
  for (let i = 0; i < wanted; i += 1) {
    const [u, v] = [(0.5 + 0.7548776662466927 * i) % 1, (0.5 + 0.5698402909980532 * i) % 1];
    const [a, b] = u + v > 1 ? [1 - u, 1 - v] : [u, v];
    const places = trianglePlaces(given, Math.floor((i * count) / wanted));
    const p = [0, 1, 2].map((k) => (1 - a - b) * places[0][k] + a * places[1][k]
      + b * places[2][k]);
    const isSeen = directions.some((direction) =>
      !tree.isMetBy(p.map((x, k) => x + 1e-6 * diagonal * direction[k]), direction));
    if (!isSeen) continue;
    seen += 1;
    if (other.distance(p) > lostBeyond * diagonal) lost += 1;
  }
  return seen > 0 ? (100 * lost) / seen : 0;
}

/** Files that a glTF names, as far as they are there. */
function resourcesOf(path, bytes) {
  if (!/\.gltf$/i.test(path)) return {};
  const names = [...Buffer.from(bytes).toString().matchAll(/"uri"\s*:\s*"([^"]+)"/g)]
    .map(([, uri]) => uri).filter((uri) => !uri.startsWith('data:'));
  return Object.fromEntries(names.flatMap((name) => {
    try {
      return [[name, readFileSync(join(dirname(path), name))]];
    } catch {
      return [];
    }
  }));
}

/** @returns {any} the tool's line; undefined where it was stopped */
function repaired(path, out) {
  try {
    return JSON.parse(execFileSync(tool, [path, out],
      { encoding: 'utf8', timeout: 1000 * mostSeconds, stdio: ['ignore', 'pipe', 'ignore'] }));
  } catch {
    return undefined;
  }
}

const isLattice = (fired) =>
  Object.keys(fired).some((name) => /^repair: (wrapped|bodies made)/.test(name));

/** @returns {any} a row; undefined for what is no mesh or too large */
function rowOf(path, folder) {
  const bytes = readFileSync(path);
  let given;
  try {
    const resources = resourcesOf(path, bytes);
    given = figuresOf(readFile(bytes, { name: basename(path), resources }));
  } catch {
    return undefined;
  }
  if (given.triangles === 0 || given.triangles > mostTriangles) return undefined;
  const extension = extname(path).toLowerCase();
  const out = join(folder, `out${extension === '.gltf' ? '.glb' : extension}`);
  const line = repaired(path, out);
  if (line?.error) return undefined;
  const row = { name: basename(path), given: given.triangles, isDone: line !== undefined };
  if (!line) return row;
  const file = readFile(readFileSync(out), { name: out });
  const written = file.parts.reduce((sum, part) => sum + part.triangles.length / 3, 0);
  const known = { ...row, ...line, isLattice: isLattice(line.fired), written,
    blowUp: written / given.triangles };
  return written > mostJudged ? known : { ...known, ...judged(given, figuresOf(file)) };
}

const judged = (given, written) => ({ open: written.boundaryEdges,
  nonManifold: written.nonManifoldEdges, crossings: written.crossings + written.crossingsAcross,
  isSound: isSound(written), kept: percentKept(given.surface, written.surface),
  lost: percentLost(given.surface, written.surface) });

/** The limits of a family that its row breaks, in words. */
function brokenLimits(name, { most, keeps, isOpen }, row) {
  if (!row?.isDone) return [`${name}: not done after ${mostSeconds} s`];
  return [...(row.written > most ? [`${name}: ${row.written} triangles > ${most}`] : []),
    ...(row.kept < 100 * keeps ? [`${name}: ${fixed(row.kept, 1)} % kept`] : []),
    ...(!isOpen && row.open > 0 ? [`${name}: ${row.open} open edges`] : []),
    ...(!isOpen && row.crossings > 0 ? [`${name}: ${row.crossings} crossing triangles`] : []),
    ...(row.lost > 1 ? [`${name}: ${fixed(row.lost, 1)} % of what is seen is lost`] : [])];
}

const cellsOf = (row) => (row.isDone
  ? [row.name, row.given, row.written, fixed(row.blowUp, 2), fixed(row.seconds, 2),
    `${row.report.mode}, ${row.report.reason}`, row.isLattice ? 'yes' : '', row.open,
    row.nonManifold, row.crossings, row.isSound ? 'yes' : '', fixed(row.kept, 1),
    fixed(row.lost, 1), row.report.warnings.map(({ code, count }) => `${code} ${count}`).join(' ')]
  : columns.map((_, k) => [row.name, row.given, 'not done'][k]));

/** Says that a file is done. */
function noted(row) {
  if (row) process.stderr.write(`${row.name}: ${row.given} → ${row.written ?? '–'}\n`);
  return row;
}

const medianOf = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];

function summary(rows) {
  const done = rows.filter((row) => row.isDone);
  const judgedOnes = done.filter((row) => row.kept !== undefined);
  const share = (test) => `${done.filter(test).length} of ${done.length}`;
  return [`triangles × ${fixed(medianOf(done.map((row) => row.blowUp)), 3)} in the median`,
    `a lattice made ${share((row) => row.isLattice)}`,
    `closed, manifold, outwards, nothing crossing: ${share((row) => row.isSound)}`,
    `more than 1 % of what is seen is lost: ${share((row) => row.lost > 1)}`,
    `bit for bit: ${fixed(medianOf(judgedOnes.map((row) => row.kept)), 1)} % in the median`]
    .join('; ');
}

/** @param {string} folder @returns {string[]} models in it and below, in order */
const modelsUnder = (folder) => readdirSync(folder, { withFileTypes: true, recursive: true })
  .filter((entry) => entry.isFile() && formats.has(extname(entry.name).toLowerCase()))
  .map((entry) => join(entry.parentPath ?? entry.path, entry.name))
  .filter((path) => statSync(path).size <= mostBytes).sort();

/** @param {string[]} folders */
export function runMended(folders, json) {
  const place = mkdtempSync(join(tmpdir(), 'remesher-mended-'));
  const rows = [], broken = [];
  try {
    for (const [name, family] of Object.entries(brokenFiles)) {
      const path = join(place, `${name}.obj`);
      writeFileSync(path, toObj(family.of()));
      const row = noted(rowOf(path, place));
      broken.push(...brokenLimits(name, family, row));
      if (row) rows.push(row);
    }
    for (const path of folders.flatMap(modelsUnder)) {
      const row = noted(rowOf(path, place));
      if (row) rows.push(row);
    }
  } finally {
    rmSync(place, { recursive: true });
  }
  if (json) writeFileSync(json, `${JSON.stringify(rows, null, 2)}\n`);
  return { table: `${markdownTable(columns, rows.map(cellsOf))}\n\n${summary(rows)}`, broken };
}
