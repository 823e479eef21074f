// SPDX-License-Identifier: MIT
// The API reference, into build/docs, out of the built package's declarations and the table of
// options. What TypeDoc complains of (a link to nothing, a name without an export) is a failure.

import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

import { Application, ReflectionKind } from 'typedoc';

import { optionsPage } from './declarations.js';

const root = dirname(dirname(dirname(fileURLToPath(import.meta.url))));

/** By the manifest: declarations by the name they are imported by. @type {Map<string, string>} */
const entries = new Map();
const { name, exports } = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8'));
for (const [path, { types }] of Object.entries(exports)) {
  if (types) entries.set(join(name, path), join(root, types));
}

const tsconfig = join(root, 'build/docs.tsconfig.json');
writeFileSync(tsconfig, JSON.stringify({
  compilerOptions: {
    strict: true, target: 'es2022', module: 'nodenext', lib: ['es2022', 'dom'], types: [],
    skipLibCheck: true,
  },
  files: [...entries.values()],
}));
const page = join(root, 'build/options.md');
writeFileSync(page, optionsPage());

const app = await Application.bootstrap({
  name,
  entryPoints: [...entries.values()],
  tsconfig,
  readme: join(root, 'README.md'),
  projectDocuments: [page, ...['CHANGELOG.md', 'CONTRIBUTING.md', 'src/README.md']
    .map((file) => join(root, file))],
  out: join(root, 'build/docs'),
  includeVersion: true,
  disableSources: true,
  githubPages: false,
  hideGenerator: true,
  treatWarningsAsErrors: true,
});
const project = await app.convert();
for (const module of project?.getChildrenByKind(ReflectionKind.Module) ?? []) {
  const file = join(root, 'dist', `${module.name}.d.ts`);
  module.name = [...entries].find(([, types]) => types === file)?.[0] ?? module.name;
}
if (project) await app.generateDocs(project, join(root, 'build/docs'));
if (!project || app.logger.hasErrors() || app.logger.hasWarnings()) process.exitCode = 1;
