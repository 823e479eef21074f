// SPDX-License-Identifier: MIT
// Pictures of the page in every state, at three sizes, light and dark, to be looked at:
//   npm run pictures                 all of them, into build/pictures
//   npm run pictures -- report error only these states
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';

import { openPage, settled, startSite } from '../support/browser_page.js';
import { root } from '../support/tree.js';
import { states } from './states.js';

const sizes = [[1440, 900], [1024, 768], [390, 844]];
const wanted = process.argv.slice(2);
const folder = join(root, 'build/pictures');

/** @param {Awaited<ReturnType<typeof startSite>>} site @param {string} name
 * @param {{ size: number[], colorScheme: string }} how */
async function take(site, name, { size: [width, height], colorScheme }) {
  const { hash, enter, isFirst } = states[name];
  const { page } = await openPage(site,
    { hash, isFirst, viewport: { width, height }, colorScheme, reducedMotion: 'reduce' });
  await settled(page);
  await enter?.(page);
  await page.evaluate(() => Promise.all([...document.images].map((image) => image.decode())));
  await page.waitForTimeout(500);  // the last frame
  const path = join(folder, `${name}-${width}x${height}-${colorScheme}.png`);
  await page.screenshot({ path });
  await page.context().close();
  console.log(path);
}

mkdirSync(folder, { recursive: true });
const site = await startSite();
try {
  const names = Object.keys(states).filter((one) => !wanted.length || wanted.includes(one));
  const looks = sizes.flatMap((size) =>
    ['light', 'dark'].map((colorScheme) => ({ size, colorScheme })));
  for (const name of names) for (const look of looks) await take(site, name, look);
} finally {
  await site.close();
}
