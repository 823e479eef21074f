// SPDX-License-Identifier: MIT
// Remeshes several models, one after the other, with the same options. The result is one ZIP, with
// a report on each model.
import { packed } from '../files/archives.js';
import { extensionOf } from '../files/files.js';
import { modelFrom } from '../files/models.js';
import { nameFor } from './names.js';

/** @typedef {import('../files/files.js').PathedFile} PathedFile */
/** @typedef {import('./address.js').Values} Values */
/** @typedef {import('./session.js').Session} Session */
/** @typedef {{ name: string, report?: import('./result.js').Report,
 *   error?: { message: string, hint?: string } }} Outcome */

/** The folder keeps models of the same name apart in the ZIP. @param {string} path */
const folderOf = (path) => path.slice(0, path.lastIndexOf('/') + 1);

/** @param {unknown} error */
const isAbort = (error) => error instanceof Error && error.name === 'AbortError';

/**
 * @param {Session} session
 * @param {{ models: PathedFile[], items: PathedFile[], values: Values }} request `items`: the
 *   models and all files that came with them
 * @param {(name: string, index: number) => void} onStart of each model
 * @returns {Promise<{ file: import('../files/files.js').NamedBytes, outcomes: Outcome[] }>}
 */
export async function remeshAll(session, { models, items, values }, onStart) {
  const files = [];
  /** @type {Outcome[]} */
  const outcomes = [];
  for (const [index, item] of models.entries()) {
    onStart(item.path, index);
    try {
      const model = await modelFrom(item, items);
      const { files: [first, ...others], report } = await session.workOnOther(model, values);
      const name = nameFor(model.name, report, extensionOf(first.name));
      files.push(...[{ ...first, name }, ...others].map((file) =>
        ({ ...file, name: folderOf(item.path) + file.name })));
      outcomes.push({ name: item.path, report });
    } catch (error) {
      if (isAbort(error)) throw error;
      const { message, hint } = /** @type {{ message: string, hint?: string }} */ (error);
      outcomes.push({ name: item.path, error: { message, hint } });
    }
  }
  const bytes = new TextEncoder().encode(`${JSON.stringify(outcomes, null, 2)}\n`);
  const file = await packed('remeshed.zip', [...files, { name: 'report.json', bytes }]);
  return { file, outcomes };
}
