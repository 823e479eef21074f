// SPDX-License-Identifier: MIT
// The built page in Chromium, for tests: served from a folder of its own, with the handful of
// gestures that a visitor makes.
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

import { build, preview } from 'vite';

import { startChromium } from './chromium.js';
import { root } from './tree.js';

/** Builds and serves the page, and starts a browser; `close` undoes all of it. */
export async function startSite() {
  const outDir = mkdtempSync(join(tmpdir(), 'remesher-web-'));
  const common = { configFile: join(root, 'web/vite.config.js'), logLevel: 'error' };
  await build({ ...common, build: { outDir, emptyOutDir: true } });
  const server = await preview({ ...common, build: { outDir }, preview: { port: 0 } });
  const browser = await startChromium();
  return {
    url: server.resolvedUrls.local[0],
    browser,
    async close() {
      await browser.close();
      await server.close();
      rmSync(outDir, { recursive: true });
    },
  };
}

/** A page with its complaints: whatever it wrote to the console as an error, or threw. */
export async function openPage(site, { hash = '', prepare = () => {}, ...options } = {}) {
  const page = await site.browser.newPage({ viewport: { width: 1200, height: 760 }, ...options });
  page.setDefaultTimeout(180_000); // all cores may be busy with other tests
  const complaints = [];
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) complaints.push(message.text());
  });
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.on('requestfailed', (request) => complaints.push(`failed: ${request.url()}`));
  await page.addInitScript(prepare);
  await page.goto(site.url + hash);
  return { page, complaints };
}

/** Waits until no job runs. */
export async function settled(page) {
  await page.waitForFunction(() => document.body.dataset.state === 'idle');
}

/** Drops files, given as { name: contents }, on the middle of the page. */
export async function drop(page, files) {
  const contents = Object.entries(files).map(([name, bytes]) =>
    [name, Buffer.from(bytes).toString('base64')]);
  const dataTransfer = await page.evaluateHandle((list) => {
    const transfer = new DataTransfer();
    for (const [name, base64] of list) {
      const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
      transfer.items.add(new File([bytes], name));
    }
    return transfer;
  }, contents);
  await page.dispatchEvent('body', 'drop', { dataTransfer });
}

/** The cells of a row of the report, by its label. */
export async function reportRow(page, label) {
  const row = page.locator('#result tbody tr', { hasText: label }).first();
  return row.locator('td').allTextContents();
}
