// SPDX-License-Identifier: MIT
// Runs one case through the package's public functions, and judges the result.
import { inspect, remesh, remeshFile } from 'remesher';

import { lawsOfErrors, lawsOfFiles, lawsOfMeshes, lawsOfQuads, lawsOfReading, lawsOfReports }
  from '../support/laws.js';

/** @typedef {import('./cases.js').Case} Case */

const filesOf = (resources = {}) =>
  Object.entries(resources).map(([name, bytes]) => ({ name, bytes }));

const isSame = (a, b) => a.length === b.length && a.every((value, i) => Object.is(value, b[i]));

/** @param {Case} input @param {object} [how] of the call: signal, worker */
async function runOnce({ mesh, file, options, output }, how) {
  if (mesh) return remesh(mesh, { ...options, ...how });
  const { name, resources } = file;
  return remeshFile(file.bytes, { ...options, name, resources, output, ...how });
}

/** The laws of a file's result. The file is read again only in its own format: other formats weld
 * vertices at the same position. */
async function judgeFile({ file, output }, result, how) {
  const { name, bytes, files, report } = result;
  const before = { ...file, files: filesOf(file.resources) };
  const broken = await lawsOfFiles(before, { name, bytes, files: files.slice(1) });
  if (report.output.triangles === 0 || output !== undefined) return broken;
  const resources = Object.fromEntries(files.slice(1).map((other) => [other.name, other.bytes]));
  const found = await inspect(bytes, { name, resources, ...how });
  return [...broken, ...lawsOfReading(found, report)];
}

/**
 * The broken laws. `repeats`: whether the case is run again, which must give the same bytes.
 * @param {Case} input
 * @param {{ how?: object, repeats?: boolean }} [context]
 * @returns {Promise<{ broken: string[], size: number, code?: string }>}
 */
export async function runCase(input, { how = {}, repeats = false } = {}) {
  let result;
  try {
    result = await runOnce(input, how);
  } catch (error) {
    if (error?.name === 'AbortError') return { broken: ['it does not end'], size: 0 };
    return { broken: lawsOfErrors(error), size: 0, code: error.code };
  }
  const { report } = result;
  const broken = lawsOfReports(report, input.options);
  if (input.mesh) broken.push(...lawsOfMeshes(result.mesh));
  else broken.push(...await judgeFile(input, result, how));
  const isRounded = report.warnings.some(({ code }) => code === 'VERTICES_COINCIDE');
  if (input.mesh && !isRounded) broken.push(...lawsOfQuads(result.mesh));
  if (repeats) {
    const again = await runOnce(input, how);
    const same = input.mesh ? isSame(again.mesh.positions, result.mesh.positions)
      && isSame(again.mesh.indices, result.mesh.indices) : isSame(again.bytes, result.bytes);
    if (!same) broken.push('another result the second time');
  }
  return { broken, size: Math.max(report.input.vertices, report.output.vertices) };
}
