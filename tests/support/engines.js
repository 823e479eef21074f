// SPDX-License-Identifier: MIT
// Engines of the core that do the same kind of work, by name, and the sizes that the architecture
// is judged by. `npm run figures` prints both; src/README.md lists the engines.
import { constantsIn } from './constants.js';
import { filesUnder, readText } from './tree.js';

/** @typedef {{ kind: string, files: readonly string[], before: number, aim: number }} Engines */

/**
 * Kinds of work with the files of `src` that do it, each without its ending.
 * @type {readonly Engines[]} before: as many when they were first counted
 */
export const engines = [
  { kind: 'edge collapse', before: 7, aim: 2, files: ['simplify/simplify', 'simplify/thin_out',
    'mesh/star_passes', 'remesh/steps/adapt', 'remesh/quads/shape/collapse',
    'remesh/conforming/thinning'] },
  { kind: 'local search around a bad face', before: 5, aim: 1, files: ['remesh/steps/local_search',
    'remesh/accuracy/lower_hausdorff', 'remesh/quads/shape/rewiring'] },
  { kind: 'sampler of distances', before: 10, aim: 3, files: ['geometry/distance_sampler',
    'remesh/accuracy/places', 'remesh/accuracy/two_sided_distance',
    'textures/painting/side_finder'] },
  { kind: 'prover of distances', before: 2, aim: 1,
    files: ['geometry/piecewise'] },
  { kind: 'search for lost tips', before: 2, aim: 1,
    files: ['remesh/accuracy/tips', 'remesh/quads/shape/quad_tips'] },
  { kind: 'shortest paths along edges', before: 4, aim: 1, files: ['mesh/shortest_paths'] },
  // The first has Bracket, which open numbers and levels by pixels use, too.
  { kind: 'search for a number by trying', before: 4, aim: 1,
    files: ['jobs/fewest_vertices', 'jobs/face_budget', 'jobs/angle_number'] },
  { kind: 'table that chooses a mesh', before: 7, aim: 1, files: ['remesh/schemes/chooser'] },
];

/** The header of an engine. @param {string} file without its ending */
export const headerOf = (file) => `src/${file}.h`;

/** The engines as src/README.md lists them. */
export const engineList = () => ['| engines | at first | today | aim | where |',
  '|---|---|---|---|---|',
  ...engines.map(({ kind, files, before, aim }) =>
    `| ${kind} | ${before} | ${files.length} | ${aim} | `
    + `${files.map((file) => `\`${file}\``).join(', ')} |`)].join('\n');

/** Sizes by name: when they were first counted, and today. @returns {string[][]} */
export function houseSizes() {
  const texts = filesUnder('src', /\.(h|cpp)$/).map(readText);
  const sum = (/** @type {(text: string) => number} */ count) =>
    texts.reduce((all, text) => all + count(text), 0);
  const counted = new Set(texts.flatMap((text) =>
    [...text.matchAll(/\bfires\("([^"]+)"\)/g)].map(([, name]) => name)));
  return [
    ['lines of the core', '50,700', sum((text) => text.split('\n').length - 1)
      .toLocaleString('en')],
    ['named constants of the core', '420, literals counted', String(
      sum((text) => constantsIn(text).length))],
    ['fallbacks and limits of work that are counted', '0', String(counted.size)],
  ];
}
