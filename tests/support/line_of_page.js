// SPDX-License-Identifier: MIT
// Serves a folder under the content security policy that docs/javascript.md describes, and returns
// the line that a page's program there prints.
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, normalize } from 'node:path';

const types = {
  '.css': 'text/css', '.html': 'text/html', '.js': 'text/javascript', '.mjs': 'text/javascript',
  '.svg': 'image/svg+xml', '.wasm': 'application/wasm',
};

const policy = "script-src 'self' 'wasm-unsafe-eval'";

/** @param {string} folder @param {string} [allowed] more sources for the policy's scripts
 * @param {Record<string, string>} [more] headers */
export async function serve(folder, allowed = '', more = {}) {
  const scripts = `${policy} ${allowed}`;
  const server = createServer(async ({ url }, response) => {
    const { pathname } = new URL(url === '/' ? '/index.html' : url, 'http://localhost');
    const bytes = await readFile(join(folder, normalize(decodeURIComponent(pathname))))
      .catch(() => {});
    response.writeHead(bytes ? 200 : 404, { ...more, 'content-security-policy': scripts,
      'content-type': types[extname(pathname)] ?? 'text/plain' });
    response.end(bytes ?? 'not found');
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', () => resolve(undefined)));
  const { port } = /** @type {import('node:net').AddressInfo} */ (server.address());
  const close = () => {
    server.close();
    server.closeAllConnections();
  };
  return { url: `http://127.0.0.1:${port}`, close };
}

/**
 * @param {import('playwright-core').Browser} browser
 * @param {string} folder to serve
 * @param {string} [path] of the page
 * @param {string} [allowed] more sources for the policy's scripts
 * @returns {Promise<{ line: string, complaints: string[] }>} the line that its program passes to
 *   `tell`, and the complaints that it wrote to the console or threw; no line if the program throws
 *   or is silent for two minutes
 */
export async function lineOfPage(browser, folder, path = '/', allowed = '') {
  const { url, close } = await serve(folder, allowed);
  const page = await browser.newPage();
  /** @type {string[]} */
  const complaints = [];
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) complaints.push(message.text());
  });
  try {
    /** @type {(line: string) => void} */
    let tell = () => {};
    const line = new Promise((resolve) => {
      tell = resolve;
      page.on('pageerror', (error) => resolve(complaints.push(String(error)) && ''));
      setTimeout(resolve, 120_000, '').unref();
    });
    await page.exposeFunction('tell', tell);
    await page.goto(url + path);
    return { line: await line, complaints };
  } finally {
    await page.close();
    close();
  }
}
