// SPDX-License-Identifier: MIT
// The built page in Chromium, for tests: served from a folder of its own, with the handful of
// gestures that a visitor makes.
import { readFileSync } from 'node:fs';
import { after } from 'node:test';

import { preview } from 'vite';

import { builtPage, configFile } from './built_page.js';
import { startChromium } from './chromium.js';

/** No step of a test waits longer: then it fails. */
const patience = 110_000;

/** Serves the built page, and starts a browser; `close` undoes both. */
export async function startSite({ isLean = false } = {}) {
  const build = { outDir: await builtPage() };
  const server = await preview({ configFile, logLevel: 'error', build, preview: { port: 0 } });
  const browser = await startChromium({ isLean });
  return {
    url: server.resolvedUrls.local[0],
    browser,
    /** The network is gone. */
    stop: () => new Promise((resolve) => {
      server.httpServer.closeAllConnections();
      server.httpServer.close(resolve);
    }),
    async close() {
      await browser.close();
      if (server.httpServer.listening) await server.close();
    },
  };
}

/** Runs in a page: the graphics card, which is software, does all that it is told but draw, unless
 * `isSeen`. */
function drawNothing() {
  const { prototype } = WebGL2RenderingContext;
  for (const name of ['drawArrays', 'drawElements']) {
    const draw = prototype[name];
    prototype[name] = function drawSeen(...request) {
      if (globalThis.isSeen) draw.apply(this, request);
    };
  }
}

/** Runs in a page: the browser keeps no page for when there is no network. */
function keepNothing() {
  delete Navigator.prototype.serviceWorker;
}

/** A lean browser reads the canvas back itself, and complains of that. */
const isBrowsersOwn = (text) => text.includes('GPU stall due to ReadPixels');

/** Runs in a page, which then complains where it does so itself. */
function tellReading() {
  const { prototype } = WebGL2RenderingContext;
  const read = prototype.readPixels;
  prototype.readPixels = function readAndTell(...request) {
    console.warn('The page waits for the graphics card: readPixels');
    read.apply(this, request);
  };
}

/** A page with its complaints: whatever it wrote to the console as an error, or threw.
 * `wasm`: served instead of the package's own. `unseen`: nobody looks at its pictures, the drawing
 * of which takes a fourth of the time. `isKept`: for when there is no network. */
export async function openPage(site,
  { hash = '', prepare = () => {}, wasm, unseen = false, isKept = true, ...options } = {}) {
  const page = await site.browser.newPage({
    viewport: { width: 1200, height: 760 }, deviceScaleFactor: unseen ? 0.5 : 1, locale: 'en-US',
    ...options });
  page.setDefaultTimeout(patience);
  const complaints = [];
  page.on('console', (message) => {
    const text = message.text();
    if (isBrowsersOwn(text)) return;
    if (['error', 'warning'].includes(message.type())) complaints.push(text);
  });
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.on('requestfailed', (request) => complaints.push(`failed: ${request.url()}`));
  await page.addInitScript(prepare);
  await page.addInitScript(tellReading);
  if (unseen) await page.addInitScript(drawNothing);
  if (!isKept) await page.addInitScript(keepNothing);
  if (wasm) {
    await page.route(/remesher-[\w-]+\.wasm$/, (route) =>
      route.fulfill({ body: Buffer.from(wasm), contentType: 'application/wasm' }));
  }
  await page.goto(site.url + hash);
  return { page, complaints };
}

/** The page that most tests of a file share, idle with its sample; closed behind the last of them.
 * Keeping it takes as long as loading it, and is not done unless asked for.
 * @param {Parameters<typeof openPage>[1]} options */
export async function visit(options) {
  const site = await startSite({ isLean: true });
  after(() => site.close());
  try {
    const arrived = await openPage(site, { isKept: false, ...options });
    await settled(arrived.page);
    return { site, ...arrived };
  } catch (error) {
    await site.close();
    throw error;
  }
}

/** Waits for a model of that name, and until it is remeshed. */
export async function opened(page, name) {
  await page.waitForFunction((wanted) =>
    document.getElementById('model-name').textContent === wanted, name);
  await settled(page);
}

/** The run of the model that is opened next is cancelled as soon as the model is shown. */
export async function cancelAtOnce(page) {
  await page.evaluate(() => {
    const observer = new MutationObserver(() => {
      observer.disconnect();
      document.getElementById('cancel').click();
    });
    observer.observe(document.getElementById('original-count'), { childList: true });
  });
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

/** The file that a click hands to the visitor. */
export async function saved(page, button) {
  const [download] = await Promise.all([page.waitForEvent('download'), page.click(button)]);
  return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
}
