// SPDX-License-Identifier: MIT
// Finds accessibility barriers of a page: faults that axe reports, and scrolling sideways.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';

const source = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

/** @returns {Promise<string[]>} axe's findings, each with its elements */
export async function barriers(page) {
  await page.evaluate(`${source}; 0`);
  return page.evaluate(async () => (await globalThis.axe.run()).violations
    .map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html).join(' ')}`));
}

/** By how many pixels the page is wider than the window. */
export const beside = (page) => page.evaluate(() =>
  document.documentElement.scrollWidth - document.documentElement.clientWidth);
