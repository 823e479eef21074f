// SPDX-License-Identifier: MIT
// Large models on the page: where memory ends that is said, a part of the triangles is drawn, and
// faults are looked for on request.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { gzipSync } from 'node:zlib';

import { cancelAtOnce, openPage, opened, settled, visit } from '../../support/browser_page.js';
import { objText, torus as ring } from '../../support/shape_files.js';
import { stl, torus } from '../../support/shapes.js';
import { withMemory } from '../../support/small_memory.js';
import { root } from '../../support/tree.js';

const sight = { hash: '#model=gear&vertices=500', unseen: true,
  viewport: { width: 800, height: 480 } };
const { site, page, complaints } = await visit(sight);

const scratch = mkdtempSync(join(tmpdir(), 'remesher-large-'));
after(() => rmSync(scratch, { recursive: true }));

test('where memory ends that is said, the last result stays, and the page goes on', async () => {
  const megabytes = 20;
  const { page: small } = await openPage(site, { ...sight, isKept: false,
    wasm: withMemory(readFileSync(join(root, 'dist/remesher.wasm')), megabytes) });
  await settled(small);
  const refused = async () => {
    await small.waitForSelector('#error:visible');
    await settled(small);
    assert.match(await small.textContent('#error'), /needs more memory than/);
    assert.equal(await small.textContent('#model-name'), 'gear.obj');
    assert.equal(await small.textContent('#result-count'), '500');
    assert.equal(await small.isVisible('.takeaway'), true);
  };
  await small.fill('#target', '60000');
  await small.click('form button[type=submit]');
  await refused();
  const large = Buffer.from(stl(torus({ columns: 1000, rows: 215 })));
  assert.ok(large.length > megabytes * 2 ** 20, 'not even the file itself has room');
  await small.setInputFiles('#file-input', { name: 'large.stl', mimeType: '', buffer: large });
  await refused();
  await small.fill('#target', '400');
  await small.click('form button[type=submit]');
  await small.waitForSelector('#result-count:text-is("400")');
  assert.equal(await small.isVisible('#error'), false);
  await small.close();
});

/** Keeps all that the bar of progress says from now on. */
const keepPhases = () => page.evaluate(() => {
  globalThis.phases = new Set();
  new MutationObserver(() => {
    globalThis.phases.add(document.getElementById('progress-phase').textContent);
  }).observe(document.getElementById('progress-phase'), { childList: true });
});

test('of a million triangles and more a part is drawn, and said so; none is lost', async () => {
  const path = join(scratch, 'large.stl');
  writeFileSync(path, stl(torus({ columns: 1250, rows: 410 })));
  await cancelAtOnce(page);
  await keepPhases();
  await page.setInputFiles('#file-input', path);
  await opened(page, 'large.stl');
  const phases = await page.evaluate(() => [...globalThis.phases]);
  for (const phase of ['Reading', 'Looking at the input', 'Preparing the picture']) {
    assert.ok(phases.includes(phase), `${phase} in ${phases}`);
  }
  assert.match(await page.textContent('#left-thinned'),
    /^9\d\d,\d{3} of 1,025,000 triangles drawn$/);
  assert.match(await page.textContent('#model-facts'), /1,025,000 triangles/);
  assert.equal(await page.getAttribute('#wireframe', 'aria-pressed'), 'false');
});

test('a packed one is the same, and what lies far within a long OBJ is found', async () => {
  const packed = join(scratch, 'large.stl.gz');
  writeFileSync(packed, gzipSync(readFileSync(join(scratch, 'large.stl')), { level: 1 }));
  await cancelAtOnce(page);
  await page.setInputFiles('#file-input', packed);
  await page.waitForFunction(() => document.body.dataset.state === 'idle'
    && document.getElementById('model-name').textContent === 'large.stl');
  assert.match(await page.textContent('#model-facts'), /1,025,000 triangles/);
  const long = `# ${'-'.repeat(3e6)}\nmtllib red.mtl\nusemtl red\n${objText(ring(24, 12))}`;
  await page.setInputFiles('#file-input', [
    { name: 'long.obj', mimeType: '', buffer: Buffer.from(long) },
    { name: 'red.mtl', mimeType: '', buffer: Buffer.from('newmtl red\nKd 1 0 0\n') }]);
  await opened(page, 'long.obj');
  assert.ok(await page.isEnabled('[data-shading=textured]'), 'its colour is there');
});

test('a large model says that faults are not looked for, and from which size', async () => {
  const path = join(scratch, 'many.stl');
  writeFileSync(path, stl(torus({ columns: 500, rows: 301 })));
  await page.setInputFiles('#file-input', path);
  await opened(page, 'many.stl');
  await page.waitForSelector('#fault-note:not([hidden])');
  assert.match(await page.textContent('#fault-note'), /not looked for: .* more than 150,000 vert/);
  await page.click('#seek-faults');
  await page.waitForSelector('#fault-note', { state: 'hidden' });
  assert.equal(await page.isVisible('#landmarks'), false, 'a torus has none');
  assert.deepEqual(complaints, []);
});

test('what has no room for its picture is opened without it, the last one is gone', async () => {
  const { page: small } = await openPage(site, { ...sight, isKept: false,
    wasm: withMemory(readFileSync(join(root, 'dist/remesher.wasm')), 195) });
  await settled(small);
  const path = join(scratch, 'long.stl');
  writeFileSync(path, stl(torus({ columns: 1300, rows: 600 })));
  await small.setInputFiles('#file-input', path);
  await small.waitForSelector('#news:text("too large to be shown")');
  await settled(small);
  assert.equal(await small.textContent('#model-name'), 'long.stl');
  assert.equal(await small.isVisible('#error'), false);
  assert.equal(await small.locator('.stage.has-original').count(), 0);
  assert.match(await small.textContent('#fault-note'), /not looked for/);
  await small.close();
});
