// SPDX-License-Identifier: MIT
// What the page hands out: every format opened again, reports, pictures, levels of detail, and the
// run as others would ask for it.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';

import { decode } from 'fast-png';
import { unzipSync } from 'fflate';
import { inspect } from 'remesher';

import { drop, opened, reportRow, saved, settled, visit } from '../../support/browser_page.js';
import { builtPage } from '../../support/built_page.js';
import { GltfMaker, validate } from '../../support/gltf.js';
import { png } from '../../support/png.js';
import { objText, torus } from '../../support/shape_files.js';
import { root } from '../../support/tree.js';

const size = { width: 800, height: 480 };
const button = (name) => `.takeaway button:text-is("${name}")`;

const { page } = await visit({ hash: '#model=vase&vertices=1000&adaptivity=0.25',
  unseen: true, viewport: size, permissions: ['clipboard-read', 'clipboard-write'] });

for (const format of ['OBJ', 'OFF', 'PLY', 'STL', 'GLB', 'glTF (ZIP)']) {
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
  assert.equal(name, 'vase-1000-report.json');
  assert.equal(JSON.parse(bytes).output.vertices, 1000);
});

test('the report card says what the page shows, and the size of the saved file', async () => {
  const { name, bytes } = await saved(page, button('Report card'));
  assert.equal(name, 'vase-1000-card.md');
  const lines = Object.fromEntries(String(bytes).split('\n').filter((line) => line.startsWith('| '))
    .map((line) => line.split('|').map((cell) => cell.trim()))
    .map(([, label, before, now]) => [label, [before, now]]));
  for (const label of ['Triangles', 'Vertices', 'Closed']) {
    assert.deepEqual(lines[label], await reportRow(page, label), label);
  }
  const label = await page.textContent('#download');
  assert.equal(`Download GLB${lines['Size of the file'][1]}`, label);
  const [, shown] = await reportRow(page, 'Largest distance');
  assert.ok(lines['Largest distance'][1].startsWith(`${Number(shown.split(' ')[0])} %`), shown);
});

test('pictures are twice the size, with the background or without', async () => {
  const canvas = await page.locator('#canvas').boundingBox();
  await page.evaluate(() => { globalThis.isSeen = true; });
  for (const [name, alpha] of [['Picture', 255], ['Picture, no background', 0]]) {
    const picture = decode((await saved(page, button(name))).bytes);
    await settled(page);
    assert.deepEqual([picture.width, picture.height],
      [2 * Math.round(canvas.width), 2 * Math.round(canvas.height)]);
    assert.equal(picture.data[3], alpha, 'the corner');
    const middle = 4 * (Math.round(picture.height / 2) * picture.width + picture.width / 4);
    assert.equal(picture.data[Math.round(middle) + 3], 255, 'the model');
  }
  await page.evaluate(() => { globalThis.isSeen = false; });
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
    assert.equal(line, 'npx remesher vase.glb -o vase-1000.glb --vertices 1000 '
      + '--adaptivity 0.25');
    const program = (await copied('JavaScript')).replace("'remesher'",
      `'${join(root, 'dist/node.js')}'`);
    writeFileSync(join(folder, 'run.mjs'), program);
    const limits = { cwd: folder, timeout: 60_000, stdio: ['ignore', 'pipe', 'inherit'] };
    execFileSync(process.execPath, ['run.mjs'], limits);
    const own = readFileSync(join(folder, 'vase-1000.glb'));
    const { bytes } = await saved(page, button('GLB'));
    assert.ok(own.equals(bytes), 'the same bytes');
    assert.match(await copied('Link to this page'), /#model=vase&vertices=1000&adaptivity=0.25$/);
  } finally {
    rmSync(folder, { recursive: true });
  }
});

/** What the progress spoke of until the page was idle again. */
async function phasesOf(act) {
  await page.evaluate(() => {
    globalThis.phases = new Set();
    new MutationObserver(([{ target }]) => globalThis.phases.add(target.textContent))
      .observe(document.getElementById('progress-phase'), { childList: true });
  });
  await act();
  await settled(page);
  return page.evaluate(() => [...globalThis.phases]);
}

const textureValues = () => Promise.all(['textures', 'textureSize', 'textureFormat'].map((name) =>
  page.inputValue(`#option-${name}`)));

test('textures are baked where that is chosen, and the progress says so', async () => {
  await page.uncheck('#live');
  assert.equal(await page.isVisible('#option-textureSize'), false);
  await page.selectOption('#option-textures', 'bake');
  await page.fill('#option-textureSize', '128');
  await page.selectOption('#option-textureFormat', 'png');
  const phases = await phasesOf(() => page.click('form button[type=submit]'));
  for (const phase of ['Decoding images', 'Painting textures', 'Encoding images']) {
    assert.ok(phases.includes(phase), phases.join());
  }
  assert.match(page.url(), /&textures=bake&textureSize=128&textureFormat=png$/);
  await page.click('.command summary');
  assert.match(await copied('Command line'),
    / --textures bake --texture-size 128 --texture-format png$/);
});

test('painted maps are looked at and saved, one by one', async () => {
  assert.deepEqual(await page.locator('.maps li > span').evaluateAll((names) =>
    names.map(({ firstChild }) => firstChild.textContent)), ['Colours', 'Normals']);
  await page.click('.map >> nth=0');
  await page.waitForFunction(() => document.getElementById('map-facts').textContent);
  assert.match(await page.textContent('#map-facts'), /^128 × 128/);
  await page.click('#map-close');
  for (const [i, name] of ['vase-1000-colours.png', 'vase-1000-normals.png'].entries()) {
    const file = await saved(page, `.maps li >> nth=${i} >> .link`);
    assert.equal(file.name, name);
    const { width, height, data, channels } = decode(file.bytes);
    assert.deepEqual([width, height], [128, 128]);
    // Colours of the vase are far apart, its normals all near the surface's own: blue.
    const blue = data.filter((_, at) => at % channels === 2);
    assert.equal(Math.min(...blue) > 128, name.includes('normals'));
  }
});

test('glTF with painted textures is valid; other formats have the surface', async () => {
  const glb = await saved(page, button('GLB'));
  assert.deepEqual(await validate(glb), []);
  const files = Object.entries(unzipSync((await saved(page, button('glTF (ZIP)'))).bytes))
    .map(([name, bytes]) => ({ name, bytes }));
  await settled(page);
  const [gltf] = files.filter(({ name }) => name.endsWith('.gltf'));
  assert.deepEqual(await validate({ ...gltf, files }), []);
  assert.equal(files.filter(({ name }) => name.endsWith('.png')).length, 2);
  const { name, bytes } = await saved(page, button('PLY'));
  await settled(page);
  assert.equal((await inspect(bytes, { name })).input.vertices, 1000);
});

test('the choice of textures is undone, done again, and in the link', async () => {
  await page.focus('#canvas');
  for (let i = 0; i < 3; i += 1) await page.keyboard.press('Control+z');
  assert.deepEqual(await textureValues(), ['', '', '']);
  for (let i = 0; i < 3; i += 1) await page.keyboard.press('Control+Shift+Z');
  assert.deepEqual(await textureValues(), ['bake', '128', 'png']);
  await page.evaluate(() => {
    location.hash = '#model=vase&vertices=300&textures=bake&textureSize=64';
  });
  await page.waitForSelector('#result-count:text-is("300")');
  await settled(page);
  assert.deepEqual(await textureValues(), ['bake', '64', '']);
  assert.match(await page.textContent('.maps'), /JPG.*PNG/);
});

test('an image that cannot be painted from is named, with what to do', async () => {
  const { positions, triangles } = torus(8, 6);
  const images = { 'half.png': png(4, 4, () => [9, 9, 9]).subarray(0, 60),
    'super.ktx2': Buffer.from([0xab, ...Buffer.from('KTX 20'), 0xbb, 0x0d, 0x0a, 0x1a, 0x0a]) };
  for (const [uri, hint] of [['half.png', /copied completely/], ['super.ktx2', /Convert it to/]]) {
    const maker = new GltfMaker();
    Object.assign(maker.tree, { images: [{ uri }], textures: [{ source: 0 }], materials: [
      { pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }] });
    maker.show([{ material: 0, indices: maker.addIndices(Uint32Array.from(triangles.flat())),
      attributes: { POSITION: maker.add(Float32Array.from(positions.flat()), 'VEC3'),
        TEXCOORD_0: maker.add(Float32Array.from(positions.flatMap(([x, y]) => [x, y])),
          'VEC2') } }]);
    await drop(page, { 'made.glb': maker.glb().bytes, [uri]: images[uri] });
    await opened(page, 'made.glb');
    await page.selectOption('#option-textures', 'bake');
    await page.click('form button[type=submit]');
    await page.waitForSelector('#error:visible');
    await settled(page);
    const text = await page.textContent('#error');
    assert.match(text, new RegExp(`made\\.glb: Image 0 \\(${uri.replace('.', '\\.')}\\)`));
    assert.match(text, hint);
  }
});

test('OBJ comes with its materials in one ZIP', async () => {
  await drop(page, { 'ring.obj': `mtllib ring.mtl\nusemtl red\n${objText(torus(16, 8))}`,
    'ring.mtl': 'newmtl red\nKd 1 0 0\n' });
  await opened(page, 'ring.obj');
  const { name, bytes } = await saved(page, button('OBJ'));
  await settled(page);
  assert.match(name, /^ring-\d+\.zip$/);
  assert.deepEqual(Object.keys(unzipSync(bytes)).sort(),
    [name.replace('.zip', '.obj'), 'ring.mtl']);
  // Its colours can be painted.
  assert.equal(await page.isVisible('#option-textures'), true);
  assert.doesNotMatch(page.url(), /textures/);
});
