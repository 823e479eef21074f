// SPDX-License-Identifier: MIT
// The versions of LLVM's tools that check these sources.
import { spawnSync } from 'node:child_process';

/** The versions of LLVM whose tools agree about these sources: those of Debian 12 and 13. */
const agreeing = ['14', '19'];

/**
 * Other versions disagree about these sources: they are not used, and the test says so.
 * @param {import('node:test').TestContext} t @param {string} tool
 * @returns {string | undefined} the tool's version, if it is one of these versions
 */
export function agreeingVersion(t, tool) {
  const { stdout } = spawnSync(tool, ['--version'], { encoding: 'utf8' });
  const [, number] = /version (\d+)/.exec(stdout) ?? [];
  if (agreeing.includes(number)) return stdout.trim();
  t.skip(`${tool} is ${number} here; the sources are held to ${agreeing.join(' and ')}`);
  return undefined;
}
