// SPDX-License-Identifier: MIT
// What stands in the way of someone on a page: barriers that axe finds, and scrolling sideways.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';

const source = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

/** @returns {Promise<string[]>} what axe finds, each with the elements it is about */
export async function barriers(page) {
  await page.evaluate(`${source}; 0`);
  return page.evaluate(async () => (await globalThis.axe.run()).violations
    .map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html).join(' ')}`));
}

/** How many pixels of the page lie beside the window. */
export const beside = (page) => page.evaluate(() =>
  document.documentElement.scrollWidth - document.documentElement.clientWidth);
