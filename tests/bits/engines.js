// SPDX-License-Identifier: MIT
// The engines that are to agree, each asked for the same jobs. A browser gets a page that does its
// work and posts the answer back: so any browser will do that can be started with an address.
import { spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { extname, join, normalize } from 'node:path';

import * as remesher from 'remesher';

import { findFirefox } from '../../bindings/build/needs.js';
import { thisSystem } from '../../bindings/build/system.js';
import { startChromium } from '../support/chromium.js';
import { root } from '../support/tree.js';
import { digestsOf } from './digests.js';
import { models } from './models.js';

const types = { '.js': 'text/javascript', '.mjs': 'text/javascript', '.wasm': 'application/wasm',
  '.html': 'text/html', '.css': 'text/css' };

const page = `<!doctype html><link rel="icon" href="data:,"><script type="module">
import * as remesher from '/dist/index.js';
import { digestsOf } from '/tests/bits/digests.js';
const load = async (name) => new Uint8Array(await (await fetch('/models/' + name)).arrayBuffer());
const answer = async () => JSON.stringify(
  await digestsOf(remesher, await (await fetch('/jobs')).json(), load));
const body = await answer().catch((error) => JSON.stringify(String(error)));
await fetch('/digests', { method: 'POST', body });
</script>`;

/** What is at each path. */
const contentFor = (jobs) => (/** @type {string} */ path) => {
  if (path === '/') return page;
  if (path === '/jobs') return JSON.stringify(jobs);
  if (path.startsWith('/models/')) return Buffer.from(models[path.slice('/models/'.length)]);
  return readFileSync(join(root, normalize(path)));
};

/** @typedef {(path: string) => string | Buffer} ContentOf what is served at a path */

/** Serves a page; `answer` is what it posts. @param {ContentOf} contentOf */
async function servePage(contentOf) {
  let post;
  const answer = new Promise((resolve) => (post = resolve));
  const server = createServer(async (request, response) => {
    if (request.method === 'POST') {
      const chunks = await request.toArray();
      post(JSON.parse(Buffer.concat(chunks).toString()));
      response.end();
      return;
    }
    const type = request.url === '/' ? types['.html']
      : types[extname(request.url)] ?? 'application/octet-stream';
    response.writeHead(200, { 'content-type': type }).end(contentOf(request.url));
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  const { port } = /** @type {import('node:net').AddressInfo} */ (server.address());
  return { url: `http://127.0.0.1:${port}/`, answer, close: () => server.close() };
}

export function inNode(jobs) {
  return digestsOf(remesher, jobs, async (name) => new Uint8Array(Buffer.from(models[name])));
}

export async function inChromium(jobs) {
  const served = await servePage(contentFor(jobs));
  const browser = await startChromium();
  try {
    await (await browser.newPage()).goto(served.url, { waitUntil: 'commit' });
    return await served.answer;
  } finally {
    await browser.close();
    served.close();
  }
}

/** What a page posts that is opened in Firefox. @param {ContentOf} contentOf */
export async function answerInFirefox(contentOf) {
  const served = await servePage(contentOf);
  const profile = mkdtempSync(join(tmpdir(), 'remesher-firefox-'));
  const browser = spawn(findFirefox(thisSystem()) ?? 'firefox',
    ['--headless', '--no-remote', '--profile', profile, served.url],
    { stdio: 'ignore', env: { ...process.env, HOME: profile, MOZ_CRASHREPORTER_DISABLE: '1' } });
  const ended = new Promise((resolve) => browser.on('exit', resolve));
  const failed = new Promise((_, reject) => browser.on('error', reject));
  try {
    return await Promise.race([served.answer, failed,
      ended.then(() => Promise.reject(new Error('Firefox ended before its answer')))]);
  } finally {
    browser.kill();
    await ended;
    served.close();
    rmSync(profile, { recursive: true, force: true });
  }
}

export const inFirefox = (jobs) => answerInFirefox(contentFor(jobs));
