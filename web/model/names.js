// SPDX-License-Identifier: MIT
// The names of saved files: the model's name, what was done to it, and the number of vertices if it
// was remeshed, as in cadsoup-repaired.stl, scan-repaired-5000.stl and horse-quads-2000.glb.

/** The report on a result; of a repair alone it has no distances.
 * @typedef {import('remesher').Inspection & { output: import('remesher').MeshReport,
 *   card: import('remesher').Card } & Partial<import('remesher').RemeshReport>} Report */

/** Whether the repair that was asked for changed the surface.
 * @param {Pick<Report, 'repair'>} report */
export function wasRepaired({ repair }) {
  if (!repair || repair.reason === 'sound') return false;
  if (repair.reason === 'joined') return true;
  const { mode, holes, islands, shells, turned } = repair;
  return mode === 'solid' || mode === 'wrap' || holes + islands + shells + turned > 0;
}

/** A name without its extension, and without the letters that some file systems refuse.
 * @param {string} name of a file */
const stemOf = (name) => name.replace(/\.[^.]*$/, '').replace(/[\p{Cc}\\/:*?"<>|]/gu, '_');

/**
 * @param {string} model the model's name
 * @param {Report} report on the result
 * @param {string} extension
 * @param {string} [detail] tells apart several files of one result, as in horse-2000-lod1.glb
 */
export function nameFor(model, report, extension, detail = '') {
  const { quads, vertices } = report.output;
  const isRemeshed = report.fidelity !== undefined;
  const done = wasRepaired(report) ? 'repaired' : isRemeshed ? '' : 'unchanged';
  const words = [stemOf(model), done, ...(isRemeshed ? [quads ? 'quads' : '', String(vertices)]
    : []), detail];
  return `${words.filter(Boolean).join('-')}.${extension}`;
}
