// SPDX-License-Identifier: MIT
// Measures anew what a named constant of the core is worth: a copy of the sources is built with
// each value instead, and the cases are remeshed to seven numbers of vertices each. The table shows
// how far the medians move.
import { execFileSync } from 'node:child_process';
import { cpSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { commonDefinitions } from '../../bindings/build/compile.js';
import { thisSystem } from '../../bindings/build/system.js';
import { withConstant } from '../support/constants.js';
import { filesUnder, root } from '../support/tree.js';
import { columns, rowOf, runsBy } from './ablation.js';
import { markdownTable } from './table.js';

const sources = ['CMakeLists.txt', 'package.json', 'src', 'tests'];
const place = join(root, 'build/sensitivity');

/** The file that defines the constant, below `src`. @param {string} constant */
function fileOf(constant) {
  const [path, name] = constant.includes(':') ? constant.split(':') : ['', constant];
  const files = filesUnder('src', /\.(h|cpp)$/).filter((file) => file.includes(path)
    && withConstant(readFileSync(join(root, file), 'utf8'), name, '0') !== undefined);
  if (files.length !== 1)
    throw new Error(`${name} is defined in ${files.length} files: ${files.join(', ')}. `
      + 'Give one as FILE:NAME');
  return { file: files[0], name };
}

/** Builds the copy. What has not changed since the value before is not compiled again. */
function build() {
  const folder = join(place, 'build');
  const words = ['-G', 'Ninja', '-S', place, '-B', folder, '-DCMAKE_BUILD_TYPE=Release',
    ...commonDefinitions(thisSystem())];
  execFileSync('cmake', words, { stdio: 'ignore' });
  execFileSync('ninja', ['-C', folder, 'ablation'], { stdio: 'ignore' });
  return join(folder, 'ablation');
}

/**
 * @param {Record<string, any>} cases
 * @param {{ folder?: string, constant: string, values: string[], names: string[] }} wanted
 */
export function runSensitivity(cases, { folder, constant, values, names }) {
  if (!constant || values.length === 0)
    throw new Error('Which constant, and which values? NAME --value V [--value V]…');
  const { file, name } = fileOf(constant);
  const own = readFileSync(join(root, file), 'utf8');
  const chosen = Object.entries(cases).filter(([label]) =>
    names.length === 0 || names.some((wanted) => label.startsWith(wanted)));
  rmSync(place, { recursive: true, force: true });
  mkdirSync(place, { recursive: true });
  for (const source of sources) {
    cpSync(join(root, source), join(place, source), { recursive: true });
  }
  const runs = (/** @type {string} */ tool) => chosen.map(([, { model, vertices }]) =>
    runsBy({ model, folder, vertices }, [''], tool)?.['']);
  const before = runs(build());
  const rows = values.flatMap((value) => {
    writeFileSync(join(place, file), withConstant(own, name, value) ?? own);
    return runs(build()).flatMap((after, k) => {
      const whole = before[k];
      return whole && after ? [rowOf(chosen[k][0], `${name} = ${value}`, whole, after)] : [];
    });
  });
  return { table: markdownTable(columns.map((column) =>
    (column === 'without' ? 'with' : column)), rows), broken: [] };
}
