// SPDX-License-Identifier: MIT
// Whether the mesh that the page shows is the mesh that it saves, in every format: by readers of
// the tests' own, the figures of the report and the numbers in the graphics card.
import assert from 'node:assert/strict';

import { unzipSync } from 'fflate';

import { drop, opened, reportRow, saved, settled } from './browser_page.js';
import {
  facesByPlace, placesOf, readSurface, rowsOf, triangulated,
} from './mesh_files.js';

/** Runs in a page: notes the jobs that workers get, and the numbers that the graphics card gets. */
export function noteWork() {
  Object.assign(globalThis, { jobs: [], uploads: [] });
  const { postMessage } = Worker.prototype;
  Worker.prototype.postMessage = function postAndNote(message, ...others) {
    if (message.job) globalThis.jobs.push(message.job.kind);
    return postMessage.call(this, message, ...others);
  };
  const { prototype } = WebGL2RenderingContext;
  const { bufferData } = prototype;
  prototype.bufferData = function bufferAndNote(target, data, ...others) {
    if (data instanceof Float32Array) globalThis.uploads.push(Array.from(data));
    return bufferData.call(this, target, data, ...others);
  };
}

const labels = { glb: 'GLB', gltf: 'glTF (ZIP)', obj: 'OBJ', off: 'OFF', ply: 'PLY',
  stl: 'STL' };

/** Saves the shown result in every format. @param {import('playwright-core').Page} page */
export async function savedInAll(page) {
  const all = {};
  for (const [format, label] of Object.entries(labels)) {
    const { name, bytes } = await saved(page, `.takeaway button:text-is("${label}")`);
    await settled(page);
    const files = name.endsWith('.zip') ? unzipSync(bytes) : { [name]: bytes };
    const news = await page.isVisible('#news') ? await page.textContent('#news') : '';
    all[format] = { name, files, surface: readSurface(files), news };
  }
  return all;
}

/** The distinct positions that the graphics card got, of those in a list. */
async function shownAmong(page, places) {
  const wanted = new Set(places);
  const shown = new Set();
  for (const upload of await page.evaluate(() => globalThis.uploads)) {
    if (upload.length % 3) continue;
    const own = placesOf(rowsOf(upload));
    if (own.every((place) => wanted.has(place))) own.forEach((place) => shown.add(place));
  }
  return [...shown].sort();
}

export const number = (text) => Number(text.replaceAll(',', ''));

/** Saves in all formats and compares them with each other, the report and the graphics card.
 * @returns what was saved */
export async function compared(page, { hasQuads = false } = {}) {
  const before = await page.evaluate(() => globalThis.jobs.length);
  const all = await savedInAll(page);
  const jobs = await page.evaluate((count) => globalThis.jobs.slice(count), before);
  // The model may still be looked through for faults.
  const own = jobs.filter((job) => job !== 'inspectFile');
  assert.deepEqual([...new Set(own)], ['convertFile'], 'nothing is remeshed again');
  const [, vertices] = await reportRow(page, 'Vertices');
  const [, faces] = await reportRow(page, hasQuads ? 'Quads' : 'Triangles');
  const { surface } = all.glb;
  const places = placesOf(surface.positions);
  assert.equal(places.length, number(vertices));
  assert.equal(surface.faces.length, number(faces));
  const stored = placesOf(surface.stored);
  assert.deepEqual(await shownAmong(page, stored), stored, 'the graphics card has them');
  for (const [format, { surface: other }] of Object.entries(all)) {
    const wanted = format === 'stl' ? triangulated(surface) : surface;
    assert.deepEqual(placesOf(other.positions), places, format);
    assert.deepEqual(facesByPlace(other), facesByPlace(wanted), format);
    if (hasQuads && format !== 'stl') {
      assert.ok(other.faces.every((face) => face.length === 4), `${format} has quads`);
    }
  }
  return all;
}

/** Opens a file, asks for so many vertices, and waits for the best result. */
export async function open(page, files, vertices, { purpose = null } = {}) {
  const [name] = Object.keys(files);
  await drop(page, files);
  await opened(page, name);
  if (purpose) await page.click(`#purpose-${purpose}`);
  await page.selectOption('.target select', 'vertices');
  await page.fill('#target', String(vertices));
  await page.click('form button[type=submit]');
  await page.waitForFunction(() => document.body.dataset.state === 'idle'
    && document.querySelector('.takeaway'));
  await page.waitForTimeout(600);  // longer than a slider has to rest
  await settled(page);
}
