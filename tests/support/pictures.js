// SPDX-License-Identifier: MIT
// Renders two glTF files from all sides in Chromium, and compares the pictures.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';

import { startChromium } from './chromium.js';
import { root } from './tree.js';

const site = 'https://pictures.test/';
const imports = {
  'three': '/node_modules/three/build/three.module.js',
  'three/addons/': '/node_modules/three/examples/jsm/',
};
const page = `<!doctype html><script type="importmap">${JSON.stringify({ imports })}</script>
<script type="module" src="/tests/support/pictures_page.js"></script>`;
const types = { js: 'text/javascript', glb: 'model/gltf-binary' };

/** The content at a path of the site: the page, a model, or a script. */
function contents(path, models) {
  if (path === '') return page;
  return models.has(path) ? Buffer.from(models.get(path)) : readFileSync(join(root, path));
}

/** A page in which to compare files; `close` ends it. Nothing is fetched from elsewhere. */
export async function openGallery() {
  const browser = await startChromium();
  const tab = await browser.newPage();
  tab.setDefaultTimeout(180_000); // all cores may be busy with other tests
  const models = new Map();
  const complaints = [];
  tab.on('console', (message) => {
    if (message.type() === 'error') complaints.push(message.text());
  });
  tab.on('pageerror', (error) => complaints.push(String(error)));
  await tab.route('**', (route) => {
    const path = route.request().url().slice(site.length);
    return route.fulfill({
      body: contents(path, models), contentType: types[path.split('.').pop()] ?? 'text/html',
    });
  });
  await tab.goto(site);
  await tab.waitForFunction('window.compare');
  return {
    /**
     * The comparison of the two pictures for each of 12 views, or of the views in `options`; see
     * pictures_page.js.
     * @returns {Promise<{ difference: number, pixels: number, strange: number, ssim: number }[]>}
     */
    async compare(original, result, options = {}) {
      models.set('original.glb', original).set('result.glb', result);
      const views = await tab.evaluate((o) => window.compare('original.glb', 'result.glb', o),
        options);
      if (complaints.length > 0) throw new Error(complaints.join('\n'));
      return views;
    },
    /** A PNG of a model from one of those views. @returns {Promise<Buffer>} */
    async picture(model, view) {
      models.set('original.glb', model);
      const uri = await tab.evaluate((v) => window.picture('original.glb', v), view);
      return Buffer.from(uri.slice(uri.indexOf(',') + 1), 'base64');
    },
    close: () => browser.close(),
  };
}
