// SPDX-License-Identifier: MIT
// The README's two commands in a clone: what becomes of them, and how long they take.

/** @typedef {import('./debian_root.js').DebianRoot} DebianRoot */

/** No machine takes as long; what does hangs. */
const longestStart = 60 * 60_000; // milliseconds

/** @param {string} address @returns {Promise<string>} what lies there */
async function fetched(address) {
  const response = await fetch(address);
  if (!response.ok) throw new Error(`${address} answers ${response.status}`);
  return response.text();
}

/** The page answers, and so does all that it names. @param {string} address */
async function checkPage(address) {
  const html = await fetched(address);
  if (!/<title>[^<]*remesher/i.test(html)) throw new Error(`${address} is not the page`);
  const parts = [...html.matchAll(/(?:src|href)="(\.\/[^"]+)"/g)].map(([, part]) => part);
  if (parts.length === 0) throw new Error(`${address} has no script`);
  for (const part of parts) await fetched(new URL(part, address).href);
}

/** `npm start`, until the page has answered. @param {DebianRoot} system */
export async function start(system) {
  /** @type {Promise<void> | undefined} */
  let checked;
  let printed = '';
  const timeout = setTimeout(() => system.stop(), longestStart);
  try {
    await system.run('npm start', (text) => {
      printed += text;
      const [, address] = /is ready at (\S+)/.exec(printed) ?? [];
      if (address) checked ??= checkPage(address).finally(() => system.stop());
    });
    throw new Error('npm start has ended by itself');
  } catch (error) {
    // What ends it is this program, once the page has been looked at.
    if (!checked) throw error;
    await checked;
  } finally {
    clearTimeout(timeout);
  }
}

/**
 * A command that ends with a report of Node's test runner.
 * @param {DebianRoot} system @param {string} command @returns how many, and its failures
 */
export async function test(system, command) {
  const { printed, passed } = await system.run(command).then(
    (text) => ({ printed: text, passed: true }),
    (error) => ({ printed: String(error.printed ?? error), passed: false }));
  const reported = printed.slice(printed.lastIndexOf('failing tests:'));
  const failures = passed ? [] : [...reported.matchAll(/^✖ .*/gm)].map(([line]) => line);
  const counts = [...printed.matchAll(/^ℹ ((?:tests|pass|fail|skipped) \d+)/gm)]
    .map(([, count]) => count).join(', ');
  return { passed, failures, counts: counts || printed.trim().split('\n').at(-1) };
}
