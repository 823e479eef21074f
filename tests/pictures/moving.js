// SPDX-License-Identifier: MIT
// Makes the moving picture of the README, docs/pictures/remesher.webp: a line goes over a bunny and
// leaves isotropic triangles behind, then quads.
//   npm run moving
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { openPage, settled, startSite } from '../support/browser_page.js';
import { root } from '../support/tree.js';
import { animated } from '../support/webp.js';

const size = { width: 640, height: 360 };
/** Pictures for one way of the line, and for the rest at its end. */
const steps = 8;
const milliseconds = { step: 130, rest: 1200 };
const quality = 0.5;

/** Runs in the page: nothing but the models and the line between them is left. */
function showOnly() {
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(`
    body * { visibility: hidden; }
    .stage { position: fixed; inset: 0; z-index: 9; height: 100vh; }
    :is(.stage, #canvas, #divider) { visibility: visible; }`);
  document.adoptedStyleSheets = [sheet];
}

/** Runs in the page: a screenshot as WebP, which the browser encodes. */
async function encode({ png, quality: share }) {
  const picture = await createImageBitmap(await (await fetch(png)).blob());
  const canvas = new OffscreenCanvas(picture.width, picture.height);
  canvas.getContext('2d').drawImage(picture, 0, 0);
  const bytes = new Uint8Array(await (await canvas.convertToBlob(
    { type: 'image/webp', quality: share })).arrayBuffer());
  return Array.from(bytes);
}

/** @param {import('playwright-core').Page} page */
async function frame(page) {
  await page.waitForTimeout(120);  // the canvas is drawn in the next frame
  const png = await page.screenshot();
  const url = `data:image/png;base64,${png.toString('base64')}`;
  return Uint8Array.from(await page.evaluate(encode, { png: url, quality }));
}

/** The line goes from right to left. @param {import('playwright-core').Page} page */
async function pass(page) {
  const frames = [];
  for (let step = 0; step <= steps; step += 1) {
    await page.evaluate((value) => {
      const divider = document.getElementById('divider');
      divider.value = value;
      divider.dispatchEvent(new Event('input'));
    }, String(1 - step / steps));
    const isEnd = step === 0 || step === steps;
    frames.push({ bytes: await frame(page),
      milliseconds: isEnd ? milliseconds.rest : milliseconds.step });
  }
  return frames;
}

const site = await startSite();
try {
  const { page } = await openPage(site, { hash: '#model=bunny&vertices=1839', viewport: size,
    colorScheme: 'light', isKept: false });
  await settled(page);
  await page.evaluate(() => document.querySelector('[data-do="compare.wipe"]').click());
  await page.evaluate(showOnly);
  await page.evaluate(() => document.querySelector('[data-do=fit]').click());
  const even = await pass(page);
  await page.evaluate(() => { location.hash = '#model=bunny&vertices=1839&quads=true'; });
  await page.waitForFunction(() => document.querySelectorAll('.history-entry').length === 2);
  await settled(page);
  await page.evaluate(() => {
    const menu = document.getElementById('baseline');
    menu.value = '1';
    menu.dispatchEvent(new Event('change'));
  });
  await settled(page);
  const quads = await pass(page);
  const path = join(root, 'docs/pictures/remesher.webp');
  const picture = animated(size, [...even, ...quads]);
  writeFileSync(path, picture);
  console.log(`${path}: ${picture.length} bytes`);
} finally {
  await site.close();
}
