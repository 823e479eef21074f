// SPDX-License-Identifier: MIT
// Which versions of LLVM's tools these sources are held to.
import { spawnSync } from 'node:child_process';

/** The versions of LLVM whose tools agree about these sources: those of Debian 12 and 13. */
const agreeing = ['14', '19'];

/**
 * Other versions have a taste of their own: they are not asked, and that is said.
 * @param {import('node:test').TestContext} t @param {string} tool
 * @returns {string | undefined} which it is, if it is one of them
 */
export function agreeingVersion(t, tool) {
  const { stdout } = spawnSync(tool, ['--version'], { encoding: 'utf8' });
  const [, number] = /version (\d+)/.exec(stdout) ?? [];
  if (agreeing.includes(number)) return stdout.trim();
  t.skip(`${tool} is ${number} here; the sources are held to ${agreeing.join(' and ')}`);
  return undefined;
}
