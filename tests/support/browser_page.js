// SPDX-License-Identifier: MIT
// The built page in Chromium, for tests: serves it from a separate folder, and performs a visitor's
// gestures.
import { readFileSync } from 'node:fs';
import { after } from 'node:test';

import { preview } from 'vite';

import { builtPage, configFile } from './built_page.js';
import { startChromium } from './chromium.js';

/** Longest wait of a test's step; after that the step fails. */
const patience = 110_000;

/** Serves the built page, and starts a browser; `close` ends both. */
export async function startSite({ isLean = false } = {}) {
  const build = { outDir: await builtPage() };
  const server = await preview({ configFile, logLevel: 'error', build, preview: { port: 0 } });
  const browser = await startChromium({ isLean });
  return {
    url: server.resolvedUrls.local[0],
    browser,
    /** Takes the network away. */
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

/** Runs in a page: WebGL, which is in software, does everything except draw; it draws only while
 * `isSeen` is set. */
function drawNothing() {
  const { prototype } = WebGL2RenderingContext;
  for (const name of ['drawArrays', 'drawElements']) {
    const draw = prototype[name];
    prototype[name] = function drawSeen(...request) {
      if (globalThis.isSeen) draw.apply(this, request);
    };
  }
}

/** Runs in a page: the page has no service worker, so it is not kept for use without network. */
function keepNothing() {
  delete Navigator.prototype.serviceWorker;
}

/** A lean browser reads the canvas back itself, and warns of its own reading. */
const isBrowsersOwn = (text) => text.includes('GPU stall due to ReadPixels');

/** Runs in a page, which then warns if the page's own code reads the canvas back. */
function tellReading() {
  const { prototype } = WebGL2RenderingContext;
  const read = prototype.readPixels;
  prototype.readPixels = function readAndTell(...request) {
    console.warn('The page waits for the graphics card: readPixels');
    read.apply(this, request);
  };
}

/** Runs in a page: the visitor has been here, and the part for experts is open. */
function comeAgain() {
  try {
    localStorage.setItem('remesher.welcome', 'seen');
    localStorage.setItem('remesher.expert', 'open');
  } catch {
    // A page without an address of its own keeps nothing.
  }
}

/** A page with its complaints: console errors and warnings, thrown errors and failed requests.
 * `wasm`: served instead of the package's own. `unseen`: nothing is drawn, because drawing takes a
 * fourth of the time. `isKept`: whether the page is kept for use without network. `isFirst`: a
 * first visit, with hints; the part for experts is closed. */
export async function openPage(site, { hash = '', prepare = () => {}, wasm, unseen = false,
  isKept = true, isFirst = false, ...options } = {}) {
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
  if (!isFirst) await page.addInitScript(comeAgain);
  if (unseen) await page.addInitScript(drawNothing);
  if (!isKept) await page.addInitScript(keepNothing);
  if (wasm) {
    await page.route(/remesher-[\w-]+\.wasm$/, (route) =>
      route.fulfill({ body: Buffer.from(wasm), contentType: 'application/wasm' }));
  }
  await page.goto(site.url + hash);
  return { page, complaints };
}

/** The page that most tests of a file share, idle with its sample; closed after the last test.
 * The page is not kept by default, because keeping it takes as long as loading it.
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

/** Waits until a model of that name is open and remeshed. */
export async function opened(page, name) {
  await page.waitForFunction((wanted) =>
    document.getElementById('model-name').textContent === wanted, name);
  await settled(page);
}

/** Cancels the run of the next opened model as soon as the model is shown. */
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

/** The file that a click downloads. */
export async function saved(page, button) {
  const [download] = await Promise.all([page.waitForEvent('download'), page.click(button)]);
  return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
}
