// SPDX-License-Identifier: MIT
// The guides and recipes in docs, each in a folder of its own: the files that it prints are
// written, its commands are run as they are printed, and what it promises is there.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import {
  existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import { after, test } from 'node:test';

import { Client } from '@modelcontextprotocol/sdk/client/index.js';
import { StdioClientTransport } from '@modelcontextprotocol/sdk/client/stdio.js';
import { inspect, remeshFile } from 'remesher';

import { startChromium } from '../support/chromium.js';
import { openGltf } from '../support/gltf.js';
import { linkInstalled } from '../support/installed.js';
import { offText, torus } from '../support/shapes.js';
import { serve } from '../support/line_of_page.js';
import { filesUnder, readText, root } from '../support/tree.js';

const folder = mkdtempSync(join(tmpdir(), 'remesher-recipes-'));
after(() => rmSync(folder, { recursive: true }));

const packages = linkInstalled(folder);

const model = new TextEncoder().encode(offText(torus({ columns: 40, rows: 20 })));
const as = async (/** @type {string} */ output) => (await remeshFile(model,
  { name: 'model.off', output, vertices: 700, quality: 'draft' })).bytes;
const models = Promise.all([as('model.obj'), as('model.glb')]);

/** The pages that are followed, by name. */
const pages = Object.fromEntries(['docs/guides', 'docs/recipes']
  .flatMap((place) => filesUnder(place, /\.md$/)).map((file) => [basename(file, '.md'), file]));

/**
 * Does all that a page says.
 * @param {string} name @returns {Promise<{ place: string, printed: string }>}
 */
async function follow(name) {
  const place = join(folder, name);
  mkdirSync(join(place, 'scans'), { recursive: true });
  writeFileSync(join(place, 'package.json'), '{ "type": "module", "private": true }');
  for (const scan of ['a', 'b', 'c']) writeFileSync(join(place, 'scans', `${scan}.off`), model);
  const [obj, glb] = await models;
  writeFileSync(join(place, 'model.obj'), obj);
  writeFileSync(join(place, 'model.glb'), glb);
  const text = readText(pages[name]);
  for (const [, file, content] of text.matchAll(/`([\w.]+)`:\n\n```\w+\n([\s\S]*?)```/g)) {
    writeFileSync(join(place, file), content);
  }
  let printed = '';
  for (const [, commands] of text.matchAll(/```sh\n([\s\S]*?)```/g)) {
    const { status, stdout, stderr } = spawnSync('bash', ['-ec', commands], { cwd: place,
      encoding: 'utf8', timeout: 120_000, stdio: ['ignore', 'pipe', 'pipe'],
      env: { ...process.env, PATH: `${join(packages, '.bin')}:${process.env.PATH}` } });
    assert.equal(status, 0, `${commands}${stderr}`);
    printed += stdout;
  }
  return { place, printed };
}

/** @param {string} path */
async function verticesIn(path) {
  const { input } = await inspect(readFileSync(path), { name: basename(path) });
  return input.vertices;
}

/** What each page promises. @type {Record<string, () => Promise<void>>} */
const recipes = {
  async node() {
    const { place, printed } = await follow('node');
    assert.match(printed, /^500 vertices, \d\.\d\d % away\n$/);
    assert.equal(await verticesIn(join(place, 'model.glb')), 500);
  },
  async vite() {
    const { place } = await follow('vite');
    await visit(join(place, 'dist'));
  },
  async three() {
    const { printed } = await follow('three');
    assert.ok(readText('docs/recipes/three.md').includes(`prints \`${printed.trim()}\``), printed);
  },
  async 'gltf-transform'() {
    const { place } = await follow('gltf-transform');
    assert.equal(await verticesIn(join(place, 'smaller.glb')), 350);
    const { tree } = openGltf({ bytes: readFileSync(join(place, 'smaller.glb')) });
    assert.deepEqual(tree.extensionsRequired, ['KHR_mesh_quantization']);
  },
  async batch() {
    const { place, printed } = await follow('batch');
    assert.deepEqual(readdirSync(join(place, 'out')), ['a.glb', 'b.glb', 'c.glb']);
    assert.equal(printed, 'a.off 400\nb.off 400\nc.off 400\n');
  },
  async queue() {
    const { place } = await follow('queue');
    assert.deepEqual(readdirSync(join(place, 'out')), ['a.glb', 'b.glb', 'c.glb']);
    assert.equal(await verticesIn(join(place, 'out/b.glb')), 500);
    for (const [, file] of readText('docs/recipes/queue.md').matchAll(/ node (\w+\.js)/g)) {
      assert.ok(existsSync(join(root, 'examples/queue', file)), file);
    }
  },
  async lods() {
    const { place, printed } = await follow('lods');
    assert.deepEqual(printed.match(/^\d+/gm), ['500', '250', '125', '50']);
    assert.equal(await verticesIn(join(place, 'model_lod3.ply')), 50);
    assert.match(readFileSync(join(place, 'model.glb'), 'latin1'), /MSFT_lod/);
  },
  async density() {
    const { printed } = await follow('density');
    // Eight to one would be 889, were there no way from one size to the other; none, 500.
    const [above] = printed.match(/^\d+/) ?? [];
    assert.ok(above > 700 && above < 889, printed);
  },
  async lighter() {
    const { place } = await follow('lighter');
    assert.equal(await verticesIn(join(place, 'lighter.glb')), 350);
  },
  async simulation() {
    const { place, printed } = await follow('simulation');
    const [angle] = /(?<=smallest angle )\d+/.exec(printed) ?? [];
    assert.ok(Number(angle) >= 20, printed);
    assert.match(printed, /closed: true\nat most \d\.\d\d % of the diagonal from the part\n/);
    assert.ok(await verticesIn(join(place, 'mesh.msh')) > 500);
  },
  async generated() {
    const { place, printed } = await follow('generated');
    assert.equal(await verticesIn(join(place, 'clean.glb')), 350);
    const [first, last] = (printed.match(/\d+(?= triangles| *$)/gm) ?? []).map(Number);
    assert.equal(first, 12800);
    assert.ok(last < 0.25 * first, printed);
  },
  async cdn() {
    const { place } = await follow('cdn');
    const elsewhere = await serve(join(root, 'dist'), '', { 'access-control-allow-origin': '*' });
    const html = readFileSync(join(place, 'index.html'), 'utf8')
      .replace(/https:\/\/cdn\.jsdelivr\.net\/npm\/remesher\/dist/, elsewhere.url);
    assert.ok(html.includes(elsewhere.url));
    writeFileSync(join(place, 'index.html'), html);
    const { url, close } = await serve(place, `'unsafe-inline' blob: ${elsewhere.url}`);
    const browser = await startChromium();
    try {
      const page = await browser.newPage();
      await page.goto(url);
      await page.waitForSelector('p:text("200 vertices, 396 triangles")');
    } finally {
      await browser.close();
      for (const end of [close, elsewhere.close]) end();
    }
  },
  async react() {
    const { place } = await follow('react');
    mkdirSync(join(place, 'node_modules/react'), { recursive: true });
    // As React does it, as far as the recipe goes: an effect runs again when its needs change.
    writeFileSync(join(place, 'node_modules/react/index.mjs'), `
      let kept, last, end;
      export const useState = (first) => [kept ?? first, (value) => { kept = value; }];
      export function useEffect(effect, needs) {
        if (last && needs.every((need, i) => need === last[i])) return;
        end?.();
        last = needs;
        end = effect();
      }`);
    writeFileSync(join(place, 'node_modules/react/package.json'),
      '{ "type": "module", "exports": "./index.mjs" }');
    writeFileSync(join(place, 'program.js'), `
      import { TorusGeometry } from 'three';
      import { useRemeshed } from './remeshed.js';
      const ring = new TorusGeometry(1, 0.4, 20, 40);
      const counts = [];
      for (const vertices of [300, 500]) useRemeshed(ring, { vertices });
      const shown = () => useRemeshed(ring, { vertices: 500 });
      const isFirst = shown() === ring;
      while (shown() === ring) await new Promise((resolve) => setTimeout(resolve, 10));
      console.log(isFirst, shown().index.count / 3);`);
    const { status, stdout, stderr } = spawnSync(process.execPath, ['program.js'],
      { cwd: place, encoding: 'utf8', timeout: 60_000 });
    assert.equal(status, 0, stderr);
    assert.equal(stdout, 'true 1000\n');
  },
  async babylon() {
    const { place } = await follow('babylon');
    writeFileSync(join(place, 'program.js'), `
      import { TorusGeometry } from 'three';
      import { remeshMesh } from './babylon.js';
      const { attributes, index } = new TorusGeometry(1, 0.4, 20, 40);
      const data = new Map(Object.entries(attributes).map(([kind, { array }]) => [kind, array]));
      let indices = index.array;
      const report = await remeshMesh({
        getVerticesData: (kind) => data.get(kind) ?? null, getIndices: () => indices,
        setVerticesData: (kind, array) => data.set(kind, array),
        setIndices: (array) => { indices = array; },
      }, { vertices: 500 });
      const count = data.get('position').length / 3;
      console.log(report.output.vertices, data.get('normal').length / count,
        data.get('uv').length / count, Math.max(...indices) === count - 1);`);
    const { status, stdout, stderr } = spawnSync(process.execPath, ['program.js'],
      { cwd: place, encoding: 'utf8', timeout: 60_000 });
    assert.equal(status, 0, stderr);
    assert.equal(stdout, '500 3 2 true\n');
  },
  async quads() {
    const { place, printed } = await follow('quads');
    const { input } = await inspect(readFileSync(join(place, 'quads.obj')), { name: 'quads.obj' });
    assert.equal(input.quads.count, input.triangles / 2);
    assert.ok(Math.abs(input.vertices - 600) <= 24);
    // As many quads as vertices around a ring, and twice as many edges.
    assert.match(printed, /true 800\nof 800 quads, \d+ irregular vertices\n1600 edges\n/);
  },
  async printing() {
    const { place, printed } = await follow('printing');
    assert.match(printed, /^(holes|solid) true$/m);
    for (const name of ['model.stl', 'mended.stl', 'print.stl']) {
      const { input } = await inspect(readFileSync(join(place, name)), { name });
      assert.deepEqual([input.boundaryEdges, input.vertices], [0, 700], name);
    }
    const name = 'within.3mf';
    assert.equal((await inspect(readFileSync(join(place, name)), { name })).unit, 'mm');
  },
  async agents() {
    const { place } = await follow('agents');
    const client = new Client({ name: 'agent', version: '1.0.0' });
    await client.connect(new StdioClientTransport(
      { command: process.execPath, args: ['server.js', '.'], cwd: place, stderr: 'ignore' }));
    try {
      const call = async (/** @type {string} */ name, /** @type {object} */ given) => {
        const answer = await client.callTool({ name, arguments: { ...given } });
        const [{ text }] = /** @type {{ text: string }[]} */ (answer.content);
        return answer.isError ? { fault: text } : JSON.parse(text);
      };
      const { tools } = await client.listTools();
      assert.deepEqual(tools.map(({ name }) => name), ['inspect', 'repair', 'remesh', 'bake']);
      assert.equal((await call('inspect', { input: 'model.obj' })).input.vertices, 700);
      const asked = { input: 'model.obj', output: 'light.glb', options: { faces: 600 } };
      const { output } = await call('remesh', asked);
      assert.ok(output.triangles <= 600);
      assert.equal(await verticesIn(join(place, 'light.glb')), output.vertices);
      await call('repair', { input: 'model.obj', output: 'mended.stl' });
      assert.equal(await verticesIn(join(place, 'mended.stl')), 700);
      const baked = { high: 'model.glb', low: 'light.glb', output: 'baked.glb' };
      assert.equal((await call('bake', baked)).fault, undefined);
      assert.equal(await verticesIn(join(place, 'baked.glb')), output.vertices);
      assert.match((await call('inspect', { input: '../other.obj' })).fault, /outside the folder/);
      assert.match((await call('remesh', { ...asked, options: { colour: 1 } })).fault, /colour/);
    } finally {
      await client.close();
    }
  },
  async seams() {
    const { printed } = await follow('seams');
    assert.equal(printed, '800 all normals still those of a side: true\n');
  },
};

/** As a visitor: a file is remeshed, then another given up. @param {string} built */
async function visit(built) {
  const browser = await startChromium();
  const { url, close } = await serve(built);
  try {
    const page = await browser.newPage();
    page.setDefaultTimeout(100_000);
    await page.goto(url);
    const give = (/** @type {Uint8Array} */ bytes) => page.setInputFiles('input',
      { name: 'torus.off', mimeType: 'application/octet-stream', buffer: Buffer.from(bytes) });
    await give(model);
    await page.waitForSelector('a[download="torus.glb"]');
    assert.equal(await page.textContent('p'), '2000 vertices: torus.glb');
    assert.ok(await page.evaluate(() => document.querySelector('progress').value) > 0.5);
    await give(new TextEncoder().encode(offText(torus({ columns: 400, rows: 200 }))));
    await page.click('button:enabled');
    await page.waitForSelector('p:text("Cancelled.")');
  } finally {
    await browser.close();
    close();
  }
}

test('every guide and recipe is tried, and listed', () => {
  assert.deepEqual(Object.keys(recipes).sort(), Object.keys(pages).sort());
  const list = readText('docs/README.md');
  assert.deepEqual(Object.values(pages).filter((file) => !list.includes(`(${file.slice(5)})`)), []);
});

for (const [name, recipe] of Object.entries(recipes)) {
  test(`${name}: the page does what it says`, { timeout: 240_000 }, recipe);
}
