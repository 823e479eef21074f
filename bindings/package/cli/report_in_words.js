// SPDX-License-Identifier: MIT
// Turns reports into text for people.

import { legible } from '../base/legible.js';
import { lengthInWords } from '../base/lengths.js';

/** @typedef {import('../base/messages.js').MeshReport} MeshReport */
/** @typedef {import('../base/messages.js').Warning} Warning */

/** @param {number} count @param {string} thing */
const counted = (count, thing) => `${count} ${thing}${count === 1 ? '' : 's'}`;

/** @param {import('../base/messages.js').QuadReport} quads */
function quadsInWords({
  count, irregular, angleDeviation, scaledJacobian, edgeVariation, symmetry, loops,
}) {
  return [
    `  ${count} quads, irregular vertices ${irregular}; off 90°: mean `
      + `${angleDeviation.mean.toFixed(1)}°, 95 % within ${angleDeviation.p95.toFixed(1)}°, worst `
      + `${angleDeviation.worst.toFixed(1)}°`,
    `  scaled Jacobian: worst ${scaledJacobian.min.toFixed(2)}, mean `
      + `${scaledJacobian.mean.toFixed(2)}; edge lengths vary by ${edgeVariation.toFixed(2)}`,
    `  ${counted(loops.count, 'loop')} of quads, the longest across ${loops.longest.toFixed(1)} % `
      + `of the edges; loops cross themselves in ${loops.selfCrossing.toFixed(1)} % of the quads`,
    ...(symmetry > 0 ? [`  mirrored exactly about ${counted(symmetry, 'plane')}`]
      : []),
  ];
}

const wantedNames = /** @type {const} */ ({ minEdge: ['edges', 'at least', 'shortest'],
  maxEdge: ['edges', 'at most', 'longest'],
  minAngle: ['angles', 'at least', 'smallest'] });

/**
 * Lengths in the model's unit, if it is known.
 * @param {import('../base/messages.js').Wanted} wanted
 * @param {{ diagonal: number, unit?: string }} model
 */
function wantedInWords(wanted, { diagonal, unit }) {
  const short = (/** @type {number} */ x) => Number(x.toPrecision(4));
  const length = (/** @type {number} */ x) => (unit === undefined ? String(short(x))
    : lengthInWords(x, unit, diagonal));
  const names = /** @type {(keyof typeof wantedNames)[]} */ (Object.keys(wantedNames));
  return names.flatMap((name) => {
    const figure = wanted[name];
    if (!figure) return [];
    const [what, limit, worst] = wantedNames[name];
    const value = name === 'minAngle' ? (/** @type {number} */ x) => `${short(x)}°` : length;
    const share = figure.missed === 0 ? 'all' : `kept by ${figure.kept.toFixed(2)} %, `
      + `missed by ${figure.missed}`;
    return [`  ${what} ${limit} ${value(figure.asked)}: ${share}; the ${worst} `
      + value(figure.worst)];
  });
}

/** @param {string} title @param {MeshReport} mesh @param {any} report of the run */
function meshInWords(title, mesh, report) {
  const { minAngle, maxAngle } = mesh;
  const shares = minAngle.histogram.map((percent) => percent.toFixed(1)).join('  ');
  return [
    `${title}: ${mesh.triangles} triangles, ${mesh.vertices} vertices, `
      + `${counted(mesh.components, 'component')}, ${mesh.boundaryEdges > 0 ? 'open' : 'closed'}`,
    `  boundary edges ${mesh.boundaryEdges}, non-manifold edges ${mesh.nonManifoldEdges}, `
      + `degenerate triangles ${mesh.degenerateTriangles}, `
      + `Euler characteristic ${mesh.eulerCharacteristic}`,
    `  minimum angle: mean ${minAngle.mean.toFixed(1)}°, worst ${minAngle.worst.toFixed(1)}°; `
      + `maximum ${maxAngle.toFixed(1)}°; vertices with six neighbours: `
      + `${mesh.valence6.toFixed(1)} %`,
    `  triangles by minimum angle, %, 0–10 … 50–60°: ${shares}`,
    ...(mesh.quads ? quadsInWords(mesh.quads) : []),
    ...wantedInWords(mesh.wanted ?? {}, report),
  ].join('\n');
}

/** The size of a model, by which lengths in its units are chosen.
 * @param {{ diagonal: number, unit?: string }} model */
const sizeOfBox = ({ diagonal, unit }) => '  diagonal of the bounding box: '
  + (unit === undefined ? `${Number(diagonal.toPrecision(4))}, in the file’s own unit`
    : lengthInWords(diagonal, unit, diagonal));

/**
 * Distances in percent, and in the model's unit if it is known.
 * @param {import('../base/messages.js').Distances} fidelity
 * @param {{ diagonal: number, unit?: string }} model
 */
function distanceInWords({ hausdorff, rms }, { diagonal, unit }) {
  const length = (/** @type {number} */ percent) => (unit === undefined ? ''
    : ` (${lengthInWords(percent / 100 * diagonal, unit, diagonal)})`);
  return `distance to the input: ${hausdorff.toFixed(4)} %${length(hausdorff)} at the farthest `
    + `point found, ${rms.toFixed(4)} %${length(rms)} RMS, of the diagonal`;
}

/** @param {import('../base/messages.js').Switch} takesOver
 * @param {{ diagonal: number, unit?: string }} model */
function switchInWords({ coverage, distance }, { diagonal, unit }) {
  const far = unit === undefined ? `${Number(distance.toPrecision(3))}`
    : lengthInWords(distance, unit, diagonal);
  return `  may be shown from a distance of ${far} on (view of 50°), or below `
    + `${(100 * coverage).toPrecision(3)} % of the screen`;
}

const reasons = {
  asked: 'as asked',
  sound: 'nothing needed repair',
  joined: 'nearly equal positions were merged; nothing else needed repair',
  closed: 'with its loops closed it is sound',
  united: 'bodies that intersect were united exactly',
  made: 'sheets became bodies',
  sheets: 'sheets enclose nothing and were left as they are',
  partly: 'what has no exact outside was remade by a lattice, all else was mended exactly',
  enclosed: 'remade as a lattice surface that encloses the visible bodies',
  open: 'remade as a lattice surface around the input, which encloses nothing clearly',
};

/** @typedef {{ diagonal: number, unit?: string }} Model its size, and the unit of its lengths */

/** `(0.5, 2, 1)`, with more digits where the model is small beside its distance from the origin.
 * @param {number[]} place @param {Model} model */
function placeInWords(place, { diagonal }) {
  const farthest = Math.max(...place.map(Math.abs));
  const more = farthest > diagonal && diagonal > 0 ? Math.ceil(Math.log10(farthest / diagonal)) : 0;
  return `(${place.map((x) => Number(x.toPrecision(Math.min(4 + more, 17)))).join(', ')})`;
}

/** `, the first near (0.5, 2, 1)` @param {number[]} places @param {Model} model */
const firstOf = (places, model) => (places.length === 0 ? ''
  : `, the first near ${placeInWords(places.slice(0, 3), model)}`);

/** @param {import('../base/messages.js').RepairSummary} repair @param {Model} model */
function lossInWords({ lost, lostBeyond, lostAt }, model) {
  const share = `  ${lost.toFixed(2)} % of the area `;
  return lostBeyond > 0 ? `${share}seen from outside is farther from the result than `
    + `${lostBeyond.toFixed(3)} % of the diagonal${firstOf(lostAt, model)}` : `${share}lost`;
}

/** ` (the widest 2.5 mm across, near (1, 2, 3))`
 * @param {import('../base/messages.js').SizedPlace[]} places @param {Model} model */
function widest(places, model) {
  if (places.length === 0) return '';
  const [{ at, across }] = places;
  const width = model.unit === undefined ? String(Number(across.toPrecision(3)))
    : lengthInWords(across, model.unit, model.diagonal);
  return ` (the widest ${width} across, near ${placeInWords(at, model)})`;
}

/** @param {import('../base/messages.js').DropSummary} dropped @param {Model} model */
function dropInWords({ pieces, hidden, lost, piecesAt }, model) {
  return `left out: ${counted(pieces, 'piece')}${widest(piecesAt, model)}, `
    + `${counted(hidden, 'hidden triangle')}; ${lost.toFixed(2)} % of the area`;
}

/** What keeps a sound surface from being a manifold. @param {number} edges */
const touching = (edges) => (edges === 0 ? ''
  : `: bodies that touch along ${counted(edges, 'edge')} stay as they are`);

/** @param {import('../base/messages.js').RepairSummary} repair @param {number} nonManifold
 * @param {Model} model */
function repairInWords(repair, nonManifold, model) {
  const { mode, reason, holes, rims, bodies, islands, shells, turned, selfIntersections } = repair;
  const [before, after] = selfIntersections;
  if (reason === 'sound' || reason === 'joined') {
    return `repair: ${reasons[reason]}${touching(nonManifold)}`;
  }
  return `repair (${mode}, ${reasons[reason]}):\n`
    + `  ${counted(holes, 'hole')} closed${widest(repair.closedAt, model)}, `
    + `${counted(islands, 'island')} and `
    + `${counted(shells, 'hidden piece')} removed, ${counted(turned, 'triangle')} turned over\n`
    + (rims > 0 ? `  ${counted(rims, 'rim')} left open${widest(repair.rimsAt, model)}\n` : '')
    + (bodies > 0 ? `  ${counted(bodies, 'sheet')} thickened to `
      + `${bodies === 1 ? 'a closed body' : 'closed bodies'}\n` : '')
    + `${lossInWords(repair, model)}\n`
    + `  self-intersecting triangles: ${before} before, ${after} after`;
}

const suggestions = {
  off: 'nothing needs repair',
  holes: 'what would repair it: holes, which closes loops, turns bodies that are inside '
    + 'out, and leaves the rest',
  solid: 'what would repair it: solid, the outside of what encloses something',
  wrap: 'what would repair it: wrap, what can be reached from outside',
};

/** `; about 120 MB and 3 s` @param {import('../base/messages.js').RepairNeeds} needs */
const needsInWords = ({ bytes, seconds }) => `; it takes about ${Math.ceil(bytes / 1e6)} MB and `
  + `${Number(seconds.toPrecision(1))} s`;

/** @typedef {Model & { faults: import('../base/messages.js').FaultSummary,
 *   input: { nonManifoldEdges: number },
 *   warnings: import('../base/messages.js').Warning[] }} Inspected */

/** @param {Inspected} report */
function cureInWords({ faults: { repair, openLoops }, input: { nonManifoldEdges }, warnings }) {
  if (repair === 'off' && warnings.some(({ code }) => code === 'ONE_SIDED')) {
    return 'repair leaves it as it is: a surface of one side has no outside; --thickness makes a '
      + 'body of it';
  }
  if (repair === 'off' && openLoops.length === 0) {
    const rounded = warnings.find((/** @type {any} */ { code }) => code === 'PLACES_JOINED');
    const cure = rounded
      ? `places that differ only by rounding are to be made one: ${rounded.count}`
      : suggestions.off;
    return `${cure}${touching(nonManifoldEdges)}`;
  }
  return repair === 'off' ? 'nothing needs repair: sheets enclose '
    + 'nothing; --repair wrap makes them thin solids, --thickness bodies, --base reliefs that stand'
    : suggestions[repair];
}

/** @param {Inspected} report */
function faultsInWords(report) {
  const { openLoops, selfIntersections, innerShells, insideOut, repair, needs, places }
    = report.faults;
  const most = 10;
  const lengths = openLoops.slice(0, most).map((length) => `${length.toPrecision(3)} %`).join(', ');
  const loops = openLoops.length === 0 ? '' : `, in length ${lengths}`
    + `${openLoops.length > most ? ', …' : ''} of the diagonal`;
  return [
    `faults: ${counted(openLoops.length, 'open loop')}${loops}${firstOf(places.openLoops, report)}`,
    `  triangles that intersect others of their part ${selfIntersections}`
      + firstOf(places.selfIntersections, report),
    `  inner shells ${innerShells}${firstOf(places.innerShells, report)}`,
    `  bodies inside out ${insideOut}${firstOf(places.insideOut, report)}`,
    `  ${cureInWords(report)}${repair === 'off' ? '' : needsInWords(needs)}`,
  ].join('\n');
}

const operations = {
  union: 'both bodies as one',
  subtract: 'the first body without the second',
  intersect: 'the common part of both bodies',
};

/** @param {import('../base/messages.js').BooleanSummary} boolean */
function booleanInWords({ operation, cut, selfIntersections }) {
  return `${operation}, ${operations[operation]}: ${counted(cut, 'triangle')} cut, `
    + `${counted(selfIntersections, 'triangle')} of the result self-intersecting`;
}

/** @param {import('../base/messages.js').AtlasSummary} atlas */
function atlasInWords({ size, charts, given, coverage, stretch, worstStretch, cage, notFound }) {
  const baked = cage === undefined ? ''
    : `\n  looked for within ${Number(cage.toPrecision(3))} % of the diagonal; `
      + `nothing found for ${Number((notFound ?? 0).toPrecision(2))} % of the texels`;
  return `texture coordinates (${given ? 'the model’s own' : 'new'}): ${counted(charts, 'chart')}, `
    + `${coverage.toFixed(1)} % of a square of ${size} texels\n`
    + `  stretch ${stretch.toFixed(2)} in the mean, ${worstStretch.toFixed(2)} at worst${baked}`;
}

/** Percent of the diagonal: anyone sees a larger distance. */
const seenByAnyone = 0.5;

/** What keeps more of the shape, where some of it was lost. @param {any} report */
function lossOfShape({ fidelity: { hausdorff }, output, prefer }) {
  if (hausdorff <= seenByAnyone) return [];
  const isLast = output.quads || [prefer].flat().includes('shape');
  return [`some shape was lost: more ${output.quads ? 'quads' : 'triangles'} keep it, or `
    + `--max-error${isLast ? '' : ', or --prefer shape'}`];
}

/** Whether a repair found nothing to do: the surface is sound, or sheets and no more.
 * @param {import('../base/messages.js').RepairSummary | undefined} repair */
const didNothing = (repair) => repair?.reason === 'sound' || repair?.reason === 'sheets'
  && [repair.holes, repair.islands, repair.shells, repair.turned].every((count) => count === 0);

/** The sentences by which the result was chosen, each once. A surface that is only rounded was not
 * changed by its repair. @param {any} report */
function chosenInWords({ chosen, repair }) {
  const rows = [chosen].flat().filter((/** @type {any} */ { rule }) =>
    !didNothing(repair) || rule !== 'repaired');
  const sentences = new Set(rows.map((/** @type {any} */ { reason }) => reason));
  return sentences.size > 0 ? [`chosen: ${[...sentences].join(' ')}`] : [];
}

/** @param {import('../base/messages.js').PresetOptions} preset */
function presetInWords(preset) {
  const flags = Object.entries(preset).map(([name, value]) => {
    const flag = `--${name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`)}`;
    return value === true ? flag : `${flag} ${value}`;
  });
  return `preset, in full: ${flags.join(' ') || 'all of its options were given otherwise'}`;
}

/** @param {number} bytes */
function sizeInWords(bytes) {
  const units = ['kB', 'MB', 'GB'];
  const step = units.findIndex((_, i) => i === 2 || bytes < 999.5e3 * 1000 ** i);
  return `${Number((bytes / 1000 ** (step + 1)).toPrecision(3))} ${units[step]}`;
}

/** @param {import('../base/messages.js').Texture[]} textures */
function texturesInWords(textures) {
  const lines = textures.map(({ name, type, width, height, bytes }) =>
    `  ${legible(name)}: ${width === undefined ? '' : `${width} × ${height}, `}`
      + `${type.replace('image/', '')}, ${sizeInWords(bytes)}`);
  const all = textures.reduce((sum, { bytes }) => sum + bytes, 0);
  return [`${counted(textures.length, 'texture')}, ${sizeInWords(all)}:`, ...lines].join('\n');
}

/** @param {import('../base/messages.js').Compression} compression */
function compressionInWords({ method, before, after, error }) {
  return `compressed by ${method}: ${sizeInWords(before)} became ${sizeInWords(after)}; positions `
    + `moved by at most ${Number(error.toPrecision(2))} % of the diagonal`;
}

/** @param {import('../base/messages.js').ConformSummary} conform */
function conformInWords({ faces, triangles, area }) {
  return `${counted(faces, 'common face')} of bodies, ${counted(triangles, 'triangle')} on both `
    + `sides, area ${Number(area.toPrecision(4))}`;
}

/** The size of the file.
 * @param {import('../base/messages.js').Card} card */
function fileInWords({ before, after }) {
  if (!after.bytes) return [];
  const given = before.bytes ? `, the input's ${sizeInWords(before.bytes)}` : '';
  return [`file: ${sizeInWords(after.bytes)}${given}`];
}

/** Of levels of detail those that the whole does not have, too.
 * @param {any} report */
function warningsInWords({ warnings, lods = [] }) {
  const said = new Set(warnings.map((/** @type {Warning} */ { message }) => message));
  const own = lods.flatMap((/** @type {{ warnings?: Warning[] }} */ lod, /** @type {number} */ i) =>
    (lod.warnings ?? []).filter(({ message }) => !said.has(message))
      .map(({ message }) => `warning: level of detail ${i + 1}: ${message}`));
  return [...warnings.map((/** @type {Warning} */ { message }) => `warning: ${message}`), ...own];
}

/** @param {any} report of a run, of an inspection, or warnings alone */
export function reportInWords(report) {
  const parts = [];
  if (report.preset) parts.push(presetInWords(report.preset));
  if (report.input) parts.push(meshInWords('input', report.input, report), sizeOfBox(report));
  if (report.faults) parts.push(faultsInWords(report));
  if (report.dropped) parts.push(dropInWords(report.dropped, report));
  if (report.repair) {
    parts.push(repairInWords(report.repair, report.input.nonManifoldEdges, report));
  }
  if (report.boolean) parts.push(booleanInWords(report.boolean));
  if (report.atlas) parts.push(atlasInWords(report.atlas));
  if (report.output) parts.push(meshInWords('output', report.output, report));
  if (report.conform) parts.push(conformInWords(report.conform));
  if (report.fidelity) {
    parts.push(distanceInWords(report.fidelity, report), ...lossOfShape(report));
  }
  if (report.chosen) parts.push(...chosenInWords(report));
  for (const [i, { output, fidelity, takesOver }] of (report.lods ?? []).entries()) {
    parts.push(meshInWords(`level of detail ${i + 1}`, output, report),
      distanceInWords(fidelity, report));
    if (takesOver) parts.push(switchInWords(takesOver, report));
  }
  if (report.textures?.length > 0) parts.push(texturesInWords(report.textures));
  if (report.compression) parts.push(compressionInWords(report.compression));
  if (report.card) parts.push(...fileInWords(report.card));
  parts.push(...warningsInWords(report));
  if (report.stopped && report.stopped !== 'target') {
    parts.push(`stopped before the target by: ${report.stopped}`);
  }
  return parts.map((part) => `${part}\n`).join('');
}
