// SPDX-License-Identifier: MIT
// What the page hands out: every format opened again, reports, pictures, levels of detail, and the
// run as others would ask for it.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { decode } from 'fast-png';
import { unzipSync } from 'fflate';
import { inspect } from 'remesher';

import { drop, openPage, saved, settled, startSite } from './support/browser_page.js';
import { builtPage } from './support/built_page.js';
import { objText, torus } from './support/shape_files.js';
import { root } from './support/tree.js';

/** @type {Awaited<ReturnType<typeof startSite>>} */
let site;
let page;
const size = { width: 800, height: 480 };
const button = (name) => `.takeaway button:text-is("${name}")`;

before(async () => {
  site = await startSite();
  ({ page } = await openPage(site, { hash: '#model=vase&vertices=1000&adaptivity=0.25',
    viewport: size, permissions: ['clipboard-read', 'clipboard-write'] }));
  await settled(page);
});

after(() => site?.close());

for (const format of ['OBJ', 'OFF', 'PLY', 'STL', 'Download GLB', 'glTF (ZIP)']) {
  test(`${format} has the vertices of the report`, async () => {
    const { name, bytes } = await saved(page, button(format));
    await settled(page);
    const files = name.endsWith('.zip') ? unzipSync(bytes) : { [name]: bytes };
    const [model] = Object.keys(files);
    const { input } = await inspect(files[model], { name: model, resources: files });
    assert.equal(input.vertices, 1000);
  });
}

test('levels of detail halve the vertices', async () => {
  const { bytes } = await saved(page, button('Levels of detail'));
  await settled(page);
  const counts = await Promise.all(Object.entries(unzipSync(bytes)).map(async ([name, file]) =>
    (await inspect(file, { name })).input.vertices));
  assert.deepEqual(counts, [1000, 500, 250, 125]);
});

test('the report is JSON', async () => {
  const { name, bytes } = await saved(page, button('Report'));
  assert.equal(name, 'vase.report.json');
  assert.equal(JSON.parse(bytes).output.vertices, 1000);
});

test('pictures are twice the size, with the background or without', async () => {
  const canvas = await page.locator('#canvas').boundingBox();
  for (const [name, alpha] of [['Picture', 255], ['Picture, no background', 0]]) {
    const picture = decode((await saved(page, button(name))).bytes);
    await settled(page);
    assert.deepEqual([picture.width, picture.height],
      [2 * Math.round(canvas.width), 2 * Math.round(canvas.height)]);
    assert.equal(picture.data[3], alpha, 'the corner');
    const middle = 4 * (Math.round(picture.height / 2) * picture.width + picture.width / 4);
    assert.equal(picture.data[Math.round(middle) + 3], 255, 'the model');
  }
});

/** What the copy button beside a heading puts on the clipboard. */
async function copied(label) {
  await page.click(`.snippet:has(h3:text-is("${label}")) button`);
  await page.waitForSelector('#news:visible');
  return page.evaluate(() => navigator.clipboard.readText());
}

test('the command line, the program and the link say the same', async () => {
  await page.click('.command summary');
  const folder = mkdtempSync(join(tmpdir(), 'remesher-out-'));
  try {
    writeFileSync(join(folder, 'vase.glb'),
      readFileSync(join(await builtPage(), 'samples/vase.glb')));
    const line = await copied('Command line');
    assert.equal(line, 'npx remesher vase.glb -o vase.remeshed.glb --vertices 1000 '
      + '--adaptivity 0.25');
    const program = (await copied('JavaScript')).replace("'remesher'",
      `'${join(root, 'dist/node.js')}'`);
    writeFileSync(join(folder, 'run.mjs'), program);
    const limits = { cwd: folder, timeout: 60_000, stdio: ['ignore', 'pipe', 'inherit'] };
    execFileSync(process.execPath, ['run.mjs'], limits);
    const own = readFileSync(join(folder, 'vase.remeshed.glb'));
    const { bytes } = await saved(page, button('Download GLB'));
    assert.ok(own.equals(bytes), 'the same bytes');
    assert.match(await copied('Link to this page'), /#model=vase&vertices=1000&adaptivity=0.25$/);
  } finally {
    rmSync(folder, { recursive: true });
  }
});

test('OBJ comes with its materials in one ZIP', async () => {
  await drop(page, { 'ring.obj': `mtllib ring.mtl\nusemtl red\n${objText(torus(16, 8))}`,
    'ring.mtl': 'newmtl red\nKd 1 0 0\n' });
  await page.waitForFunction(() => document.getElementById('model-name').textContent
    === 'ring.obj');
  await settled(page);
  const { name, bytes } = await saved(page, button('OBJ'));
  await settled(page);
  assert.equal(name, 'ring.zip');
  assert.deepEqual(Object.keys(unzipSync(bytes)).sort(), ['ring.mtl', 'ring.obj']);
});
