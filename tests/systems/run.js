// SPDX-License-Identifier: MIT
// The README's two commands and the linters on fresh Debians, each in a folder of its own, as root:
//   npm run systems -- trixie bookworm [--commit REV] [--keep]
// Each suite takes half an hour on two cores, and 6 GB meanwhile; all that is printed is in
// build/systems/SUITE.log. --keep leaves the system in its folder. Ends with status 1 if a command
// failed, and leaves nothing else behind however it ends.
import { spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { parseArgs } from 'node:util';

import { root as checkout } from '../support/tree.js';
import { DebianRoot } from './debian_root.js';
import { start, test } from './readme_commands.js';

const begun = performance.now();
const minutes = (/** @type {number} */ since) => {
  const seconds = Math.round((performance.now() - since) / 1000);
  return `${Math.floor(seconds / 60)} min ${seconds % 60} s`;
};

/**
 * @template T
 * @param {string} what
 * @param {() => T | Promise<T>} step
 * @returns {Promise<T>}
 */
async function timed(what, step) {
  const since = performance.now();
  const value = await step();
  console.log(`  ${what}: ${minutes(since)}`);
  return value;
}

/** @param {DebianRoot} system @param {string} commit @returns {Promise<boolean>} */
async function tryCommands(system, commit) {
  const node = await timed('the system', () => system.make());
  console.log(`  Node is of ${node}: ${(await system.run('node --version')).trim()}`);
  await timed(`commit ${commit.slice(0, 10)}`, () => system.takeClone(commit));
  await timed('npm start, until the page has answered', () => start(system));
  let passedAll = true;
  for (const command of ['npm test', 'npm run lint']) {
    const { passed, counts, failures } = await timed(command, () => test(system, command));
    console.log(`  ${counts}`);
    for (const line of failures) console.log(`  ${line}`);
    passedAll &&= passed;
  }
  return passedAll;
}

/** The system that runs, for an interrupt to end. @type {DebianRoot | undefined} */
let current;
let isInterrupted = false;

/** @param {string} suite @param {{ commit: string, isKept: boolean }} how */
async function trySuite(suite, { commit, isKept }) {
  console.log(`Debian ${suite}`);
  const system = new DebianRoot(suite, join(checkout, 'build/systems', `${suite}.log`));
  current = system;
  try {
    return await tryCommands(system, commit);
  } catch (error) {
    console.log(`  failed: ${error.message}\n${String(error.printed ?? '').slice(-2000)}`);
    return false;
  } finally {
    const folder = await system.end(isKept);
    if (folder) console.log(`  it stays in ${folder}`);
  }
}

const { values, positionals: suites } = parseArgs({ allowPositionals: true,
  options: { commit: { type: 'string', default: 'HEAD' }, keep: { type: 'boolean' } } });
const { status, stdout } = spawnSync('git',
  ['-C', checkout, 'rev-parse', '--verify', '--quiet', `${values.commit}^{commit}`],
  { encoding: 'utf8' });
const fault = (suites.length === 0 && 'Which suites? npm run systems -- trixie bookworm')
  || (status !== 0 && `There is no commit ${values.commit}`)
  || (process.getuid?.() !== 0 && 'Only root can make a system')
  || (spawnSync('debootstrap', ['--version']).error && 'debootstrap is missing: '
    + 'apt-get install debootstrap');
if (fault) {
  console.error(fault);
  process.exit(2);
}

for (const signal of ['SIGINT', 'SIGTERM', 'SIGHUP']) {
  process.on(signal, () => {
    isInterrupted = true;
    process.exitCode = 1;
    void current?.interrupt();
  });
}
for (const suite of suites) {
  if (isInterrupted) break;
  const how = { commit: stdout.trim(), isKept: Boolean(values.keep) };
  if (!await trySuite(suite, how)) process.exitCode = 1;
}
console.log(`${process.exitCode ? 'Something failed' : 'All passed'}, ${minutes(begun)}`);
