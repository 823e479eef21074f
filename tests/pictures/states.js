// SPDX-License-Identifier: MIT
// The states of the page that pictures are taken of: how each is reached from a fresh page.
import { drop, settled } from '../support/browser_page.js';
import { objText, torus } from '../support/shape_files.js';

const ring = objText(torus(24, 12));
const measured = (page) => page.waitForSelector('#distances:not([hidden])',
  { state: 'attached' });
const click = (page, selector) => page.locator(selector).dispatchEvent('click');

/** On a phone the part for experts is a sheet, which is closed at first. */
const showExpert = (page) => page.evaluate(() => {
  document.getElementById('expert').open = true;
});

/** Chooses a purpose, and waits for its result. */
async function choose(page, purpose) {
  await click(page, `#purpose-${purpose}`);
  await page.waitForFunction(() => document.body.dataset.state === 'idle'
    && !document.getElementById('download').disabled);
}

/** isFirst: a first visit; hash: the address; enter: what is done there.
 * @type {Record<string, { hash: string, isFirst?: boolean,
 *   enter?: (page: any) => Promise<unknown> }>} */
export const states = {
  arrival: { hash: '', isFirst: true },
  lighter: { hash: '#model=vase', isFirst: true, enter: (page) => choose(page, 'asset') },
  printable: { hash: '#model=scan', isFirst: true, enter: (page) => choose(page, 'print') },
  simulation: { hash: '#model=gear', isFirst: true, enter: (page) => choose(page, 'simulation') },
  quads: { hash: '#model=bunny', isFirst: true, enter: (page) => choose(page, 'quads') },
  mechanical: { hash: '#model=gear', enter: (page) => click(page, '#features') },
  scan: { hash: '#model=scan', enter: (page) => click(page, '#landmark-boundary') },
  textured: { hash: '#model=vase' },
  baked: { hash: '#model=vase&textures=bake', enter: async (page) => {
    await showExpert(page);
    await page.locator('.maps').scrollIntoViewIfNeeded();
  } },
  map: { hash: '#model=vase&textures=bake', enter: (page) => click(page, '.map >> nth=0') },
  german: { hash: '#model=scan&vertices=20', enter: async (page) => {
    await click(page, '[data-do=settings]');
    await page.selectOption('#language', 'de');
    await click(page, '#settings-close');
  } },
  parts: { hash: '#model=teapot' },
  angles: { hash: '#model=bunny', enter: (page) => click(page, '[data-shading=angles]') },
  normals: { hash: '#model=bunny', enter: (page) => click(page, '[data-shading=normals]') },
  distances: { hash: '#model=gear', enter: async (page) => {
    await measured(page);
    await click(page, '#visit-largest');
  } },
  report: { hash: '#model=bunny', enter: async (page) => {
    await measured(page);
    await showExpert(page);
    await click(page, '.command > summary');
    await page.locator('.takeaway').scrollIntoViewIfNeeded();
  } },
  options: { hash: '#model=bunny&adaptivity=1', enter: (page) => click(page, '.more > summary') },
  history: { hash: '#model=bunny', enter: async (page) => {
    await click(page, '#preset-accurate');
    await page.waitForSelector('.history-entry', { state: 'attached' });
    await settled(page);
    await showExpert(page);
    await page.selectOption('#baseline', '1');
    await settled(page);
    await page.locator('.history').scrollIntoViewIfNeeded();
  } },
  painting: { hash: '#model=bunny&vertices=1500', enter: async (page) => {
    await click(page, '#paint');
    await page.locator('#brush-strength').fill('2');
    await page.locator('#brush-size').fill('0.2');
    await page.focus('#canvas');
    await page.keyboard.press('Enter');
    await page.waitForTimeout(800);
    await settled(page);
  } },
  guides: { hash: '#model=bunny', enter: async (page) => {
    await choose(page, 'quads');
    await click(page, '#guides');
    await page.focus('#canvas');
    for (const key of ['Enter', 'ArrowRight', 'ArrowRight', 'Enter']) {
      await page.keyboard.press(key);
    }
    await click(page, '#pencil-finish');
    await page.waitForTimeout(800);
    await settled(page);
  } },
  settings: { hash: '#model=bunny', enter: (page) => click(page, '[data-do=settings]') },
  chooser: { hash: '#model=bunny', enter: async (page) => {
    await drop(page, { 'ring.obj': ring, 'parts/second ring.off': ring });
    await page.waitForSelector('#chooser[open]');
  } },
  error: { hash: '#model=bunny', enter: async (page) => {
    await drop(page, { 'broken.glb': 'no glTF' });
    await page.waitForSelector('#error:visible');
    await settled(page);
  } },
  busy: { hash: '#model=gear', enter: async (page) => {
    await page.fill('#target', '150000');
    await page.keyboard.press('Enter');
    await page.waitForTimeout(3500);
  } },
};
