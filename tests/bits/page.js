// SPDX-License-Identifier: MIT
// The page in Firefox, which has no 3-D where it has no screen: all but the picture is tried, in a
// frame that a page around it drives.
import { readFileSync } from 'node:fs';
import { join, normalize } from 'node:path';

import { builtPage } from '../support/built_page.js';
import { root } from '../support/tree.js';
import { answerInFirefox } from './engines.js';

const around = `<!doctype html><link rel="icon" href="data:,">
<iframe width="1200" height="760" src="/index.html#model=gear&vertices=500"></iframe>
<script type="module">
import { laws } from '/tests/bits/page_laws.js';
const frame = document.querySelector('iframe');
await new Promise((resolve) => frame.addEventListener('load', resolve));
const body = await laws(frame.contentWindow).catch((error) => [[String(error), false]]);
await fetch('/answer', { method: 'POST', body: JSON.stringify(body) });
</script>`;

/** @returns {Promise<[string, boolean][]>} what was tried, and whether it holds */
export async function pageInFirefox() {
  const folder = await builtPage();
  return answerInFirefox((path) => {
    if (path === '/') return around;
    return readFileSync(join(path.startsWith('/tests/') ? root : folder, normalize(path)));
  });
}
