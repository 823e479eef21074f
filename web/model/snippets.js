// SPDX-License-Identifier: MIT
// The page's run as a command line and as JavaScript.
import { optionTable, repairNames } from 'remesher/options';
import { isRepairOnly, optionsIn } from './purposes.js';

/** output: the name of the file that the run writes; guides: of the file with guides, if any.
 * @typedef {{ input: string, output: string, guides?: string,
 *   values: import('./address.js').Values }} Run */

/** A file's name, quoted for a shell. @param {string} name */
const quoted = (name) => (/^[\w.-]+$/.test(name) ? name : `'${name.replaceAll("'", "'\\''")}'`);

/** The options that the run takes, with their values. @param {Run['values']} values */
const optionsOf = (values) => Object.entries(optionsIn(values)).filter(([name]) =>
  !isRepairOnly(values) || repairNames.some((own) => own === name));

/** The same run on the command line. @param {Run} run */
export function commandLine({ input, output, guides, values }) {
  const given = optionsOf(values).filter(([, value]) => value !== false);
  const flags = given.map(([name, value]) => {
    const flag = optionTable.find((option) => option.name === name)?.flag?.split(' ')[0];
    return value === true ? flag : `${flag} ${value}`;
  });
  const command = `npx remesher${isRepairOnly(values) ? ' repair' : ''}`;
  const lines = guides ? ['--guides', quoted(guides)] : [];
  return [command, quoted(input), '-o', quoted(output), ...flags, ...lines].join(' ');
}

/** A word as JavaScript writes it. @param {string | number | boolean} value */
const literal = (value) => (typeof value === 'string'
  ? `'${value.replaceAll('\\', '\\\\').replaceAll("'", "\\'")}'` : String(value));

/** The same run in a program for Node. @param {Run} run */
export function javaScript({ input, output, values }) {
  const act = isRepairOnly(values) ? 'repairFile' : 'remeshFile';
  const options = [['name', input], ['output', output], ...optionsOf(values)]
    .map(([name, value]) => `${name}: ${literal(value)}`);
  return [
    "import { readFile, writeFile } from 'node:fs/promises';",
    `import { ${act} } from 'remesher';`,
    '',
    `const bytes = await readFile(${literal(input)});`,
    `const result = await ${act}(bytes, { ${options.join(', ')} });`,
    `await writeFile(${literal(output)}, result.bytes);`,
    'console.log(result.report.output);',
  ].join('\n');
}
