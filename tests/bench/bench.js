// SPDX-License-Identifier: MIT
// The benchmark: named models to named numbers of vertices, in this process, on one thread.
//   npm run bench -- [--models FOLDER] [--runs N] [--markdown FILE] [case…]    best and rounds
//   npm run bench -- table1 FOLDER [--markdown FILE]                           the report's Table 1
//   npm run bench -- ablation --models FOLDER [--without STEP]… [case…]   steps left out
//   npm run bench -- fires --models FOLDER [FOLDER…]    how often each fallback fires
//   npm run bench -- assets [FOLDER…]   textured models through the preset, beside meshoptimizer's
//   npm run bench -- bake FOLDER [--markdown FILE]      textures: kept, baked, and meshoptimizer's
//   npm run bench -- scale [--markdown FILE]                                   a large model
//   npm run bench -- large [case…]     millions of triangles, beside meshoptimizer; takes minutes
//   npm run bench -- parts [--models FOLDER] [case…]     machine parts, beside other programs
//   npm run bench -- mended [--json FILE] [FOLDER…]     broken files: what repair makes of each
//   npm run bench -- page --models FOLDER [--runs N]          how long visitors of the page wait
//   npm run bench -- quads --models FOLDER [case…]                          quads, by one evaluator
//   npm run bench -- quadshare [--models FOLDER] [--json FILE] [model…]   runs that artists keep
//   npm run bench -- repair [--models FOLDER] [--json FILE] [--wrap] [case…]   broken surfaces
//   npm run bench -- readme --models FOLDER           the figures that README.md prints
//   npm run bench -- sensitivity NAME --value V… --models FOLDER [case…]   a constant's worth
//   npm run bench -- trust --models FOLDER [FOLDER…]  files under the laws of trust, by their bytes
//   npm run bench -- wait --models FOLDER [--runs N] [case…]    how long people wait, in units
// A case is named as in limits.json, or by the beginning of its name. Without a folder of models
// only the models from npm packages are run. The status is 1 if a limit is broken.
import { readFileSync, writeFileSync } from 'node:fs';
import { parseArgs } from 'node:util';

import { runAblation } from './ablation.js';
import { runAssets } from './assets.js';
import { runBake } from './bake.js';
import { runCases } from './cases.js';
import { runFires } from './fires.js';
import { runLarge } from './large.js';
import { runMended } from './mended.js';
import { runPage } from './page.js';
import { runParts } from './parts.js';
import { runQuadShare } from './quad_share.js';
import { runQuads } from './quads.js';
import { runReadme } from './readme.js';
import { runRepair } from './repair.js';
import { runScale } from './scale.js';
import { runSensitivity } from './sensitivity.js';
import { runTable1 } from './table1.js';
import { runTrust } from './trust.js';
import { runWait } from './wait.js';

const limits = JSON.parse(readFileSync(new URL('limits.json', import.meta.url), 'utf8'));

const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: {
    models: { type: 'string' },
    runs: { type: 'string', default: '5' },
    markdown: { type: 'string' },
    json: { type: 'string' },
    wrap: { type: 'boolean', default: false },
    without: { type: 'string', multiple: true, default: [] },
    value: { type: 'string', multiple: true, default: [] },
  },
});

function run() {
  const [first, ...rest] = positionals;
  switch (first) {
    case 'ablation':
      return runAblation(limits.cases,
        { folder: values.models, names: rest, steps: values.without });
    case 'assets': return runAssets([values.models ?? [], rest].flat());
    case 'fires': return runFires([values.models ?? [], rest].flat());
    case 'table1': return runTable1(limits.table1, rest[0] ?? values.models);
    case 'bake': return runBake(limits.bake, rest[0] ?? values.models);
    case 'scale': return runScale(limits.scale);
    case 'large': return runLarge(limits.large, rest);
    case 'mended':
      return runMended([values.models, ...rest].filter(Boolean), values.json);
    case 'page':
      return runPage(limits.page, { folder: values.models, runs: Number(values.runs) });
    case 'parts': return runParts(limits.parts, { folder: values.models, names: rest });
    case 'quads': return runQuads(limits.quads, { folder: values.models, names: rest });
    case 'quadshare':
      return runQuadShare({ folders: values.models ? [values.models] : [], names: rest,
        json: values.json });
    case 'repair':
      return runRepair(limits.repair, { folder: values.models, names: rest, json: values.json,
        wrap: values.wrap });
    case 'readme': return runReadme(values.models);
    case 'sensitivity':
      return runSensitivity(limits.cases, { folder: values.models, constant: rest[0],
        values: values.value, names: rest.slice(1) });
    case 'trust': return runTrust([values.models, ...rest].filter(Boolean));
    case 'wait':
      return runWait(limits.wait,
        { folder: values.models, names: rest, runs: Number(values.runs) });
    default:
      return runCases(limits.cases,
        { folder: values.models, names: positionals, runs: Number(values.runs) });
  }
}

const { table, broken } = await run();
console.log(`\n${table}\n`);
for (const line of broken) console.log(line);
if (values.markdown) writeFileSync(values.markdown, `${table}\n`);
if (broken.length > 0) process.exitCode = 1;
