// SPDX-License-Identifier: MIT
// The way of most visitors of the page: a purpose, one number, the verdict, the download.
import assert from 'node:assert/strict';

import { unzipSync } from 'fflate';

import { barriers, beside } from './barriers.js';
import { drop, opened, saved, settled } from './browser_page.js';
import { readSurface } from './mesh_files.js';
import { stl, torus as torusArrays } from './shapes.js';

export const ring = torusArrays({ columns: 40, rows: 20 });

/** The verdict's sentences, once the result is final and its distances are known. */
export async function verdict(page) {
  await settled(page);
  await page.waitForFunction(() => !document.getElementById('download').disabled
    && document.querySelector('#distances:not([hidden])'));
  return (await page.locator('.verdict li').allTextContents()).join('\n');
}

/** Chooses a purpose as visitors do, and waits for its result. */
export async function choose(page, purpose) {
  await page.click(`#purpose-${purpose}`);
  assert.equal(await page.getAttribute(`#purpose-${purpose}`, 'aria-pressed'), 'true');
  return verdict(page);
}

/** The file behind the button, which is in view without scrolling. */
export async function download(page) {
  await page.evaluate(() => scrollTo(0, 0));
  const { top, bottom } = await page.locator('#download').evaluate((button) =>
    button.getBoundingClientRect());
  const { height } = page.viewportSize();
  assert.ok(top > 0 && bottom <= height, `the button from ${top} to ${bottom} of ${height}`);
  const label = await page.textContent('#download');
  const { name, bytes } = await saved(page, '#download');
  await settled(page);
  const files = name.endsWith('.zip') ? unzipSync(bytes) : { [name]: bytes };
  return { name, bytes, label, surface: readSurface(files) };
}

const number = (text) => Number(text.replaceAll(',', ''));
/** The number before a word in the verdict. */
export const said = (text, word) =>
  number(new RegExp(`([\\d,]+) ${word}`).exec(text)?.[1] ?? 'none');

/**
 * Each purpose, driven by real events in a window of this size: its file is opened by a reader of
 * the tests' own and compared with what was said.
 * @param {import('playwright-core').Page} page @param {[width: number, height: number]} size
 */
export async function eachPurpose(page, [width, height]) {
  await page.setViewportSize({ width, height });
  await drop(page, { 'ring.stl': stl(ring) });
  await opened(page, 'ring.stl');
  assert.match(await page.textContent('#model-size'), /^5\.6 × 5\.6 × 1\.6/);
  await page.selectOption('#unit', 'mm');
  assert.ok(await beside(page) <= 0);

  const sound = await choose(page, 'print');
  assert.match(sound, /Closed.*\nNothing had to be repaired/);
  const same = await download(page);
  assert.equal(same.name, 'ring-unchanged.stl');
  assert.ok(same.bytes.equals(Buffer.from(stl(ring))), 'byte for byte');

  await page.click('#work-remesh');
  const printed = await verdict(page);
  const [, most] = /At most ([\d.]+) mm|lies exactly/.exec(printed);
  assert.ok(Number(most ?? 0) <= Number(await page.inputValue('#amount')), printed);

  const lighter = await choose(page, 'asset');
  const light = await download(page);
  assert.equal(said(lighter, 'triangles'), light.surface.faces.length);
  assert.equal(light.surface.faces.length, number(await page.inputValue('#amount')));
  assert.match(light.name, /^ring-\d+\.stl$/);
  assert.match(light.label, /^Download STL[\d.]+ kB$/);
  assert.ok(lighter.includes(`${light.label.slice('Download STL'.length)} as STL`), lighter);

  const simulated = await choose(page, 'simulation');
  assert.match(simulated, /Smallest angle [345]\d\.\d°/);
  const { surface } = await download(page);
  const edges = surface.faces.flatMap((face) => face.map((v, i) => Math.hypot(
    ...surface.positions[v].map((x, k) => x - surface.positions[face[(i + 1) % 3]][k]))));
  const mean = edges.reduce((sum, edge) => sum + edge) / edges.length;
  assert.ok(Math.abs(mean / Number(await page.inputValue('#amount')) - 1) < 0.1, `${mean}`);
  const [, saidMean] = /Edges ([\d.]+) mm on average/.exec(simulated);
  assert.ok(Math.abs(mean / Number(saidMean) - 1) < 0.01, `${mean}, ${saidMean} said`);

  const solver = await saved(page, '#besides button:text-is("INP")');
  assert.match(solver.name, /^ring-\d+\.inp$/);
  await settled(page);

  // An STL cannot hold quads, so they are saved as what can.
  const quads = await choose(page, 'quads');
  const squared = await download(page);
  assert.equal(said(quads, 'quads'), squared.surface.faces.length);
  assert.ok(squared.surface.faces.every((face) => face.length === 4));
  assert.match(squared.name, /^ring-quads-\d+\.obj$/);
  assert.deepEqual(await barriers(page), []);
}
