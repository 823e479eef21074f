// SPDX-License-Identifier: MIT
// Node, Chromium and Firefox give the same bytes, and the page works in Firefox: npm run bits. Ends
// with status 1 if not.
import { inChromium, inFirefox, inNode } from './engines.js';
import { jobs } from './models.js';
import { pageInFirefox } from './page.js';

const wanted = await inNode(jobs);
process.stdout.write(`Node: ${jobs.length} results, ${new Set(wanted).size} different ones\n`);
for (const [engine, run] of [['Chromium', inChromium], ['Firefox', inFirefox]]) {
  const found = await run(jobs);
  const wrong = jobs.filter((_, i) => found[i] !== wanted[i]);
  process.stdout.write(`${engine}: ${jobs.length - wrong.length} of ${jobs.length} are the same\n`);
  for (const job of wrong) process.stdout.write(`  not ${JSON.stringify(job)}\n`);
  if (wrong.length > 0) process.exitCode = 1;
}

for (const [law, holds] of await pageInFirefox()) {
  process.stdout.write(`the page in Firefox: ${law}: ${holds ? 'yes' : 'NO'}\n`);
  if (!holds) process.exitCode = 1;
}
