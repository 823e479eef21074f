// SPDX-License-Identifier: MIT
// Builds the documentation as one site in build/docs: the reference, made from the built package's
// declarations and the table of options, the recipes and the papers. Any complaint of TypeDoc (a
// link to nothing, a name without an export) is a failure. Pages with figures that live get their
// scenes and the package. A current site is not made again.
import { cpSync, existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { basename, join } from 'node:path';

import { addressOf } from './addresses.js';
import { optionsPage } from './declarations.js';
import { root, say } from './say.js';
import { Stamp } from './stamp.js';

/** @typedef {import('typedoc').DocumentReflection} DocumentReflection */

const out = 'build/docs';
const optionsFile = 'build/options.md';
const look = 'bindings/build/docs.css';

/** @param {string} file @returns {string} */
const read = (file) => readFileSync(join(root, file), 'utf8');

/** The pages of a folder of docs, in the order of docs/README.md. @param {string} folder */
const pagesOf = (folder) =>
  [...read('docs/README.md').matchAll(new RegExp(`\\]\\((${folder}/[\\w-]+\\.md)\\)`, 'g'))]
    .map(([, path]) => `docs/${path}`);

/** The pages beside the reference, as in the navigation. @type {Record<string, string[]>} */
const groups = {
  Guides: ['docs/README.md', ...pagesOf('guides')],
  Recipes: pagesOf('recipes'),
  Reference: [optionsFile, ...['javascript', 'command-line', 'formats', 'textures', 'sizes',
    'quality', 'comparison', 'how-it-works'].map((name) => `docs/${name}.md`), 'SECURITY.md'],
  Project: ['CHANGELOG.md', 'CONTRIBUTING.md', 'src/README.md', 'tests/README.md'],
};
const papers = Object.values(groups).flat();

const scenes = 'web/scenes';

/** The files of the package that only Node or the command line need, or other packages' users. */
const notOfPages = /\.d\.m?ts$|_node|^(cli|files|adapters)$/;

/** The files that a page with live figures loads: scenes import the package as everyone does. */
const liveFigures = `<script type="importmap">{ "imports": { "remesher": "../package/index.js",
  "remesher/arrays": "../package/arrays.js" } }</script>
  <script type="module" src="../scenes/scenes.js"></script>`;

/** Puts the scenes and the package beside the pages. */
function addScenes() {
  cpSync(join(root, scenes), join(root, out, 'scenes'), { recursive: true });
  cpSync(join(root, 'dist'), join(root, out, 'package'), { recursive: true,
    filter: (file) => !notOfPages.test(basename(file)) });
}

/** The manifest's entries: the declarations of each import name. */
function entriesOf() {
  /** @type {Map<string, string>} */
  const entries = new Map();
  const { name, exports } = JSON.parse(read('package.json'));
  for (const [path, { types }] of Object.entries(exports)) {
    if (types) entries.set(join(name, path), join(root, types));
  }
  return entries;
}

/** All files that the site is made from. */
function inputs() {
  const below = (/** @type {string} */ folder, /** @type {RegExp} */ pattern) =>
    readdirSync(join(root, folder), { recursive: true, encoding: 'utf8' })
      .filter((file) => pattern.test(file)).map((file) => join(folder, file)).sort();
  return ['README.md', ...papers, look, 'package.json', 'node_modules/.package-lock.json',
    ...below('dist', /\.(d\.m?ts|js|wasm)$/), ...below('bindings', /\.js$/),
    ...below('examples', /\.js$/), ...below(scenes, /\.js$/)];
}

/** @param {Iterable<string>} files @returns its path from the root */
function configureTypes(files) {
  const tsconfig = 'build/docs.tsconfig.json';
  writeFileSync(join(root, tsconfig), JSON.stringify({
    compilerOptions: {
      strict: true, target: 'es2022', module: 'nodenext', lib: ['es2022', 'dom'], types: [],
      skipLibCheck: true,
    },
    files: [...files],
  }));
  return tsconfig;
}

/** Names a page by its heading and puts it into its group.
 * @param {DocumentReflection} page @param {string} file */
function place(page, file) {
  const [, heading] = /^# (.+)$/m.exec(read(file)) ?? [];
  page.name = heading ?? file;
  page.frontmatter.group = Object.keys(groups).find((group) => groups[group].includes(file));
}

/** A page all of whose parts that scroll the keyboard can reach, and screen readers by landmarks.
 * @param {string} html */
const reachable = (html) => html.replaceAll('<table>', '<table tabindex="0">')
  .replace('<div class="col-content">', '<div class="col-content" role="main">')
  .replace('<div class="col-sidebar">',
    '<div class="col-sidebar" role="complementary" aria-label="Contents">')
  .replaceAll(/<h3>(?=Settings|On This Page)/g, '<h3 aria-level="2">');

/** The README's links to the documentation, which here are links within it. @param {string} html */
const withinSite = (html) =>
  html.replaceAll(`href="${addressOf(JSON.parse(read('package.json')))}docs/"`, 'href="index.html"')
    .replaceAll(`href="${addressOf(JSON.parse(read('package.json')))}docs/`, 'href="');

/** @returns {Promise<boolean>} whether all went well */
async function make() {
  const { Application, Converter, PageEvent, ReflectionKind } = await import('typedoc');
  const entries = entriesOf();
  const app = await Application.bootstrap({
    name: 'remesher',
    entryPoints: [...entries.values()],
    tsconfig: join(root, configureTypes(entries.values())),
    readme: join(root, 'README.md'),
    projectDocuments: papers.map((file) => join(root, file)),
    out: join(root, out),
    customCss: join(root, look),
    includeVersion: true,
    disableSources: true,
    githubPages: false,
    hideGenerator: true,
    searchInDocuments: true,
    sortEntryPoints: false,
    headings: { readme: false },
    navigation: { includeGroups: true },
    // A name that begins with what is sought counts up to ten times as much: properties would be
    // first, though whoever seeks has a job.
    searchGroupBoosts: { Guides: 40, Recipes: 8, Reference: 8, Functions: 2, Properties: 0.05,
      Methods: 0.2 },
    groupOrder: ['Guides', 'Recipes', 'Reference', 'Modules', 'Functions', 'Classes', 'Interfaces',
      'Type Aliases', 'Variables', '*', 'Project'],
    treatWarningsAsErrors: true,
  });
  app.renderer.on(PageEvent.END, (page) => {
    page.contents = page.contents && reachable(page.contents);
    if (page.contents && page.url === 'index.html') page.contents = withinSite(page.contents);
    if (page.contents?.includes('data-scene='))
      page.contents = page.contents.replace('</head>', `${liveFigures}</head>`);
  });
  let pages = 0;
  app.converter.on(Converter.EVENT_CREATE_DOCUMENT,
    (_, page) => place(page, papers[pages++]));
  const project = await app.convert();
  for (const module of project?.getChildrenByKind(ReflectionKind.Module) ?? []) {
    const file = join(root, 'dist', `${module.name}.d.ts`);
    module.name = [...entries].find(([, types]) => types === file)?.[0] ?? module.name;
  }
  if (project) await app.generateDocs(project, join(root, out));
  addScenes();
  return Boolean(project) && !app.logger.hasErrors() && !app.logger.hasWarnings();
}

writeFileSync(join(root, optionsFile), optionsPage());
const stamp = new Stamp('build/docs.stamp', inputs());
if (!stamp.isCurrent() || !existsSync(join(root, out))) {
  say(`Making the documentation in ${out}/`);
  if (await make()) stamp.set();
  else process.exitCode = 1;
}
