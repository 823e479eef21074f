// SPDX-License-Identifier: MIT
// The law "said is written": the figures of a report are those of the written file, which is read
// without the engine. Returns the broken laws in words.
import { distances } from '../independent/distance.js';
import { diagonalOf } from '../independent/surface.js';

const counts = ['vertices', 'triangles', 'components', 'boundaryEdges', 'nonManifoldEdges'];

/** Degrees: the last digits of an angle depend on the formula, most where it is nearly 180. */
const angleRounding = 0.01;

/** The warning of one of these codes, if there is one.
 * @param {any} report @param {string[]} codes */
export const warningOf = ({ warnings }, ...codes) =>
  warnings.find((/** @type {any} */ { code }) => codes.includes(code));

function lawsOfCounts(written, said) {
  return counts.filter((name) => written[name] !== said[name])
    .map((name) => `${name}: ${said[name]} said, ${written[name]} written`);
}

function lawsOfAngles(written, said) {
  const pairs = [['least angle', written.minAngle.worst, said.minAngle.worst],
    ['mean of least angles', written.minAngle.mean, said.minAngle.mean],
    ['largest angle', written.maxAngle, said.maxAngle]];
  return pairs.filter(([, a, b]) => !(Math.abs(a - b) <= angleRounding))
    .map(([name, a, b]) => `${name}: ${b}° said, ${a}° written`);
}

/** Formats that write a quad as one face. */
const holdsQuads = (/** @type {string} */ name) => !/\.stl(\.gz)?$/i.test(name);

function lawsOfQuads(written, said, name) {
  if (!said.quads || !holdsQuads(name)) return [];
  const broken = [];
  if (said.quads.count !== written.quads) {
    broken.push(`quads: ${said.quads.count} said, ${written.quads} written`);
  }
  return broken;
}

/** Only the file's own materials. */
function lawsOfMaterials(written, before) {
  if (!written.materials || !before.materials) return [];
  return [...written.materials].filter((name) => !before.materials.has(name))
    .map((name) => `a material ${JSON.stringify(name)} that the input does not have is written`);
}

/** Codes that say that materials are lost, and that they are lost but for their names. */
const ofMaterials = { materials: ['PARTS_MERGED'],
  looks: ['PARTS_MERGED', 'MATERIALS_BY_NAME', 'RESOURCE_NOT_GIVEN'] };

/** Attributes and materials that the result lacks are named by a warning. */
function lawsOfLosses(written, before, { warnings }) {
  const isSaid = (name) => warnings.some(({ code, message }) => ofMaterials[name]?.includes(code)
    || (code === 'ATTRIBUTE_NOT_CARRIED'
      && message.includes(name === 'looks' ? 'materials' : name)));
  return [...before.holds].filter((name) => !written.holds.has(name) && !isSaid(name))
    .map((name) => `${name}: in the input, not written, nothing said`);
}

/** Crossings within meshes and across them: counted by repair, or by a warning. */
function lawsOfCrossings(written, report) {
  const within = report.repair?.selfIntersections[1];
  const warning = warningOf(report, 'CROSSINGS_LEFT', 'SELF_INTERSECTIONS_MADE');
  const across = warningOf(report, 'PARTS_MEET', 'SELF_INTERSECTIONS_MADE');
  const broken = [];
  if (within !== undefined && within !== written.crossings) {
    broken.push(`crossings: ${within} said, ${written.crossings} written`);
  } else if (within === undefined && warning && warning.count !== written.crossings
    && written.crossingsAcross === 0) {
    broken.push(`crossings: ${warning.count} warned of, ${written.crossings} written`);
  } else if (written.crossings > 0 && within === undefined && !warning) {
    broken.push(`crossings: nothing said, ${written.crossings} written`);
  }
  if (written.crossingsAcross > 0 && !across) {
    broken.push(`crossings of parts: nothing said, ${written.crossingsAcross} written`);
  }
  return broken;
}

/** The distance that is said, against samples of the written file, which can only be nearer.
 * @param {any} before @param {any} written figures @param {any} report */
export function lawsOfDistance(before, written, { fidelity }) {
  if (!fidelity || written.triangles === 0 || before.shown > 1) return [];
  const { there, back } = distances(before.surface, written.surface, 4000);
  const found = 100 * Math.max(there.distance, back.distance) / diagonalOf(before.surface);
  return found <= 1.02 * fidelity.hausdorff + 0.01 ? []
    : [`hausdorff: ${fidelity.hausdorff} % said, ${found} % at least written`];
}

/**
 * @param {ReturnType<typeof import('../independent/figures.js').figuresOf>} written
 * @param {any} report
 * @param {{ name: string, before: any }} file the written one; before: the input's figures. Where
 *   the input had crossings and nobody asked for a repair, none need be said.
 */
export function lawsOfWriting(written, report, { name, before }) {
  const said = report.output;
  const isCrossed = !report.repair && before.crossings + before.crossingsAcross > 0;
  return [...lawsOfCounts(written, said), ...(written.polygons ? [] : lawsOfAngles(written, said)),
    ...lawsOfQuads(written, said, name), ...lawsOfMaterials(written, before),
    ...lawsOfLosses(written, before, report),
    ...(isCrossed ? [] : lawsOfCrossings(written, report)),
    ...(report.repair ? [] : lawsOfDistance(before, written, report))];
}
