// SPDX-License-Identifier: MIT
// The README as npm shows it, from the tarball alone: no dead link, its picture there, its programs
// and commands run as they are printed. The programs of the papers that it leads to run, too.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync }
  from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';

import { convertFile } from 'remesher';

import { addressOf } from '../../bindings/build/addresses.js';
import { buildDocs } from '../support/built_docs.js';
import { builtPage } from '../support/built_page.js';
import { startChromium } from '../support/chromium.js';
import { call } from '../support/fresh_project.js';
import { linkInstalled } from '../support/installed.js';
import { serve } from '../support/line_of_page.js';
import { offText, plyText, sheet, stl, torus } from '../support/shapes.js';
import { readText, root } from '../support/tree.js';

const folder = mkdtempSync(join(tmpdir(), 'remesher-readme-'));
after(() => rmSync(folder, { recursive: true }));
const packages = linkInstalled(folder);

const [{ filename }] = JSON.parse(
  call('npm', ['pack', '--json', '--ignore-scripts', '--pack-destination', folder], root));
call('tar', ['-xzf', filename], folder);
const tarball = join(folder, 'package');
const text = readFileSync(join(tarball, 'README.md'), 'utf8');
const address = addressOf(JSON.parse(readFileSync(join(tarball, 'package.json'), 'utf8')));

const off = offText(torus({ columns: 40, rows: 20 }));
const converted = async (/** @type {string} */ output) =>
  (await convertFile(new TextEncoder().encode(off), { name: 'torus.off', output })).bytes;
const colours = ['red', 'green', 'blue'].map((name) => `\nproperty uchar ${name}`).join('');
const coloured = plyText(sheet()).replace('float z', `float z${colours}`)
  .replace(/^[-\d.e]+ [-\d.e]+ [-\d.e]+$/gm, '$& 200 100 0');

for (const place of ['scans', 'models']) mkdirSync(join(folder, place));
for (const [name, content] of Object.entries({
  'package.json': '{ "type": "module", "private": true }', 'horse.obj': await converted('obj'),
  'horse.glb': await converted('glb'), 'models/b.off': off, 'scans/a.stl': stl(torus()),
  'scan.stl': stl(torus()), 'part.stl': stl(torus()), 'drill.stl': stl(torus({ radius: 1.7 })),
})) writeFileSync(join(folder, name), content);

/** @param {string} command @param {string[]} words @returns what it prints */
function outputOf(command, words) {
  const { status, stdout, stderr } = spawnSync(command, words, { cwd: folder, encoding: 'utf8',
    timeout: 120_000, stdio: ['ignore', 'pipe', 'pipe'],
    env: { ...process.env, PATH: `${join(packages, '.bin')}:${process.env.PATH}` } });
  assert.equal(status, 0, stderr);
  return stdout;
}

const report = [/10000 vertices, \d+ bytes/, /minimum angle: mean \d\d\.\d°, worst \d\d\.\d°/,
  /distance to the original: \d\.\d{3} % of the diagonal/];
const ofThree = { finds: `import { Group, Mesh, TorusGeometry } from 'three';
const mesh = new Mesh(new TorusGeometry(1, 0.4, 20, 40));
const gltf = { scene: new Group().add(new Mesh(mesh.geometry)) };` };

/** Of each paper's programs, in their order: what it finds, what is asked of it then, and the
 * answer. */
const programs = {
  'README.md': [
    { finds: '', asks: '', answer: /^\d\d\.\d+ 0\.\d+$/ },
    { ...ofThree, asks: '', answer: /^\d+ \[ 'position', 'normal', 'uv' \]$/ },
  ],
  'docs/javascript.md': [
    { finds: '', asks: '', answer: new RegExp(report.map(({ source }) => source).join('\n')) },
    { finds: `const files = [new File([${JSON.stringify(off)}], 'a.off')];`,
      asks: 'results[0].name + results[0].report.output.vertices', answer: /^a\.off400$/ },
    { ...ofThree, asks: 'report.output.vertices', answer: /^10000$/ },
    { finds: `import { NodeIO } from '@gltf-transform/core';
const document = await new NodeIO().read('horse.glb');`,
    asks: "document.getRoot().listAccessors().map((each) => each.getCount()).join(' ')",
    answer: /\b10000\b/ },
  ],
  'docs/textures.md': [
    { finds: `const file = new File([${JSON.stringify(coloured)}], 'scan.ply');`,
      asks: "String(bytes.slice(0, 4)) + String(bytes).includes('255,216,255')",
      answer: /^103,108,84,70true$/ },
  ],
};

for (const [paper, expected] of Object.entries(programs)) {
  test(`the programs of ${paper} do what is said beside them`, { timeout: 240_000 }, () => {
    const printed = [...readText(paper).matchAll(/```js\n([^]*?)```/g)];
    assert.equal(printed.length, expected.length);
    for (const [i, { finds, asks, answer }] of expected.entries()) {
      writeFileSync(join(folder, 'program.js'),
        `${finds}\n${printed[i][1]}\n${asks && `console.log(${asks});`}`);
      assert.match(outputOf(process.execPath, ['program.js']).trim(), answer);
    }
    const [, said] = readText(paper).match(/prints\n\n((?: {4}.+\n)+)/) ?? [];
    if (said) assert.match(said.replace(/^ {4}/gm, '').trim(), expected[0].answer);
  });
}

test('the commands work, those of the README and those of the paper on them',
  { timeout: 240_000 }, () => {
    const [, ours] = text.match(/```sh\n([^]*?)```/) ?? [];
    const [, more] = readText('docs/command-line.md').match(/^((?: {4}npx .+\n)+)/m) ?? [];
    for (const commands of [ours, more]) {
      const lines = commands.trim().split(/\n */);
      assert.ok(lines.length >= 5);
      rmSync(join(folder, 'out'), { recursive: true, force: true });
      for (const line of lines) outputOf('bash', ['-ec', `set -o pipefail; ${line}`]);
      assert.deepEqual(readdirSync(join(folder, 'out')), ['a.glb', 'b.glb']);
    }
  });

/** The README's references: [name]: address. */
const references = new Map([...text.matchAll(/^\[([\w-]+)\]: (\S+)$/gm)]
  .map(([, name, target]) => [name, target]));
const used = [...text.matchAll(/\]\[([\w-]+)\]/g)].map(([, name]) => name);
const direct = [...text.matchAll(/(!?)\[[^\]]*\]\(([^)\s]+)\)/g)]
  .map(([, mark, target]) => ({ isPicture: mark === '!', target }));

test('no link is dead: each is absolute, and ours lead to pages of the site', async () => {
  assert.deepEqual([...references.keys()].sort(), [...new Set(used)].sort());
  const links = [...references.values(),
    ...direct.filter(({ isPicture }) => !isPicture).map(({ target }) => target)];
  assert.deepEqual(links.filter((link) => !/^https:\/\//.test(link)), []);
  buildDocs();
  const page = await builtPage();
  for (const link of links.filter((one) => one.startsWith(address))) {
    const [path, place] = link.slice(address.length).split('#');
    const file = path.startsWith('docs/') ? join(root, 'build', path) : join(page, path);
    const target = path === '' || path.endsWith('/') ? join(file, 'index.html') : file;
    assert.ok(existsSync(target), link);
    if (place) assert.match(readFileSync(target, 'utf8'), new RegExp(`id="${place}"`), link);
  }
});

test('its picture is in the tarball, moves, and is no larger than a megabyte', () => {
  const pictures = direct.filter(({ isPicture }) => isPicture);
  assert.ok(pictures.length >= 1);
  for (const { target } of pictures) {
    const bytes = readFileSync(join(tarball, target));
    assert.ok(bytes.length < 1_000_000, `${target}: ${bytes.length}`);
    assert.equal(bytes.toString('latin1', 8, 12), 'WEBP');
    assert.ok(bytes.toString('latin1').split('ANMF').length > 8, 'frames');
  }
});

test('its page without a build works', { timeout: 120_000 }, async () => {
  const [, html] = text.match(/```html\n([^]*?)```/) ?? [];
  const elsewhere = await serve(join(root, 'dist'), '', { 'access-control-allow-origin': '*' });
  writeFileSync(join(folder, 'index.html'), `<!doctype html><link rel="icon" href="data:,">${
    html.replace('https://cdn.jsdelivr.net/npm/remesher/dist', elsewhere.url)}`);
  const { url, close } = await serve(folder, `'unsafe-inline' blob: ${elsewhere.url}`);
  const browser = await startChromium({ isLean: true });
  try {
    const page = await browser.newPage();
    await page.goto(url);
    await page.waitForFunction(() => /\d+ triangles, \d+ bytes/.test(document.title));
  } finally {
    await browser.close();
    for (const end of [close, elsewhere.close]) end();
  }
});
