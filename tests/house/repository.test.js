// SPDX-License-Identifier: MIT
// What people expect of a repository: its papers, forms and workflows are well-formed, agree with
// each other, and name only what is there; a release is refused where they do not.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';

import { optionTable } from 'remesher/options';
import { parse } from 'yaml';

import { addressOf, withAddress } from '../../bindings/build/addresses.js';
import { releaseNotes, sectionsOf } from '../../bindings/build/release.js';
import { filesUnder, readText, root } from '../support/tree.js';

const manifest = JSON.parse(readText('package.json'));
const changelog = readText('CHANGELOG.md');
const yaml = (file) => parse(readText(file));

test('the manifest says where the repository is, in one place', () => {
  const { repository, bugs, homepage } = manifest;
  const [, address] = /^git\+(https:\/\/[\w.-]+(?:\/[\w.-]+)+)\.git$/.exec(repository.url) ?? [];
  assert.equal(repository.type, 'git');
  assert.equal(bugs.url, `${address}/issues`);
  assert.equal(new URL(homepage).protocol, 'https:');
  const { host } = new URL(address);
  const others = ['CHANGELOG.md', 'SECURITY.md', 'CITATION.cff',
    ...filesUnder('.github', /./), ...filesUnder('docs', /\.md$/)]
    .filter((file) => readText(file).includes(`${host}/`));
  if (host.endsWith('.example')) assert.deepEqual(others, []);
});

test('the README leads to the manifest’s address, and to no other of ours', () => {
  const readme = readText('README.md');
  assert.equal(withAddress(readme, addressOf(manifest)), readme, 'npm run addresses writes them');
  const moved = withAddress(readme, 'https://elsewhere.example/there/');
  assert.ok(!moved.includes(addressOf(manifest)));
  assert.equal(withAddress(moved, addressOf(manifest)), readme);
  assert.throws(() => withAddress('nothing', 'https://a.example/'), /no line \[demo\]/);
});

/** Of the format's schema, 1.2.0: what a file and a reference may have, and must. */
const citable = {
  file: { may: ['cff-version', 'message', 'title', 'type', 'abstract', 'authors', 'license',
    'keywords', 'references', 'version', 'date-released', 'doi', 'url', 'repository-code'],
  must: ['cff-version', 'message', 'title', 'authors'] },
  reference: { may: ['type', 'title', 'authors', 'collection-title', 'conference', 'publisher',
    'year', 'start', 'end', 'doi'], must: ['type', 'title', 'authors'] },
};

/** @param {Record<string, unknown>} entry @param {{ may: string[], must: string[] }} keys */
function assertKeys(entry, { may, must }) {
  assert.deepEqual(Object.keys(entry).filter((key) => !may.includes(key)), []);
  assert.deepEqual(must.filter((key) => !entry[key]), []);
}

/** A person or an entity, whose keys differ. */
const isAuthor = (author) =>
  ['name', 'family-names,given-names'].includes(Object.keys(author).sort().join())
  && Object.values(author).every((name) => name.trim());

test('CITATION.cff is in the Citation File Format, and true', () => {
  const { 'cff-version': format, ...citation } = yaml('CITATION.cff');
  assertKeys({ 'cff-version': format, ...citation }, citable.file);
  assert.equal(format, '1.2.0');
  assert.equal(citation.type, 'software');
  assert.equal(citation.title, manifest.name);
  assert.equal(citation.license, manifest.license);
  assert.equal(citation.version ?? manifest.version, manifest.version);
  assert.ok(readText('LICENSE').includes(citation.authors[0].name));
  assert.deepEqual(citation.keywords, [...new Set(citation.keywords)]);
  for (const reference of citation.references) {
    assertKeys(reference, citable.reference);
    assert.equal(reference.type, 'conference-paper');
    assert.match(reference.doi, /^10\.\d{4,9}\/[\w:/;\-.()[\]\\]+$/);
    for (const number of ['year', 'start', 'end']) assert.ok(Number.isInteger(reference[number]));
    for (const entity of ['conference', 'publisher']) assert.ok(isAuthor(reference[entity]));
  }
  const authors = [citation, ...citation.references].flatMap((entry) => entry.authors);
  assert.ok(authors.every(isAuthor));
  const names = authors.map((author) => author['family-names']);
  for (const name of ['Surazhsky', 'Gotsman']) assert.ok(names.includes(name), name);
});

const forms = filesUnder('.github/ISSUE_TEMPLATE', /\.yml$/)
  .filter((file) => !file.endsWith('/config.yml'));

test('GitHub can show the forms for issues', () => {
  assert.equal(forms.length, 2);
  assert.equal(yaml('.github/ISSUE_TEMPLATE/config.yml').blank_issues_enabled, false);
  for (const file of forms) {
    const { name, description, body } = yaml(file);
    assert.ok(name && description && body.length > 0, file);
    const asked = body.filter(({ type }) => type !== 'markdown');
    const ids = asked.map(({ id }) => id);
    assert.deepEqual(ids, [...new Set(ids)]);
    assert.ok(ids.every((id) => /^[\w-]+$/.test(id)), file);
    assert.ok(asked.every(({ type }) => ['input', 'textarea'].includes(type)), file);
    assert.ok(asked.every(({ attributes }) => attributes.label), file);
    assert.ok(asked.some(({ validations }) => validations?.required), file);
    const told = body.filter(({ type }) => type === 'markdown');
    assert.ok(told.every(({ attributes }) => attributes.value), file);
  }
});

test('the forms name options, commands and papers that there are', () => {
  const text = forms.map(readText).join('\n');
  const flags = [...optionTable.map(({ flag }) => flag?.split(' ')[0]), '--json', '--version'];
  for (const [flag] of text.matchAll(/--[a-z][\w-]*/g)) assert.ok(flags.includes(flag), flag);
  for (const [, file] of text.matchAll(/`([\w/]+\.md)`/g)) {
    assert.ok(existsSync(join(root, file)), file);
  }
  const command = join(root, 'dist/cli/cli.js');
  const { stdout: help } = spawnSync(process.execPath, [command, '--help'], { encoding: 'utf8' });
  const commands = [...text.matchAll(/npx remesher(?:@\w+)? ([a-z]+) /g)].map(([, name]) => name);
  assert.ok(commands.length >= 2);
  for (const name of commands) assert.ok(help.includes(`remesher ${name} <input>`), name);
});

/** Of all workflows: their steps, with the permissions they run under. */
const jobs = filesUnder('.github/workflows', /\.yml$/).flatMap((file) => {
  const workflow = yaml(file);
  return Object.entries(workflow.jobs).map(([name, job]) => ({ file, name,
    permissions: job.permissions ?? workflow.permissions, needs: job.needs, steps: job.steps }));
});
const commandsOf = (job) => job.steps.flatMap(({ run }) => run ?? []).join('\n');

test('workflows run scripts and files that there are, and may no more than they say', () => {
  assert.ok(jobs.length >= 3);
  for (const job of jobs) {
    const lines = commandsOf(job);
    const scripts = [...lines.matchAll(/\bnpm (?:run ([\w:-]+)|(start|test)\b)/g)]
      .map(([, named, plain]) => named ?? plain);
    assert.deepEqual(scripts.filter((name) => !manifest.scripts[name]), [], job.file);
    const files = [...lines.matchAll(/\bnode (\S+\.js)/g)].map(([, file]) => file);
    assert.deepEqual(files.filter((file) => !existsSync(join(root, file))), [], job.file);
    assert.ok(job.permissions, `${job.file} says what ${job.name} may do`);
  }
});

test('what npm gets has been checked and tested, by a job that may publish nothing', () => {
  const [publishing, ...more] = jobs.filter((job) => /npm publish/.test(commandsOf(job)));
  assert.deepEqual(more, []);
  assert.match(commandsOf(publishing), /npm publish --provenance/);
  assert.deepEqual(publishing.permissions, { contents: 'write', 'id-token': 'write' });
  const tested = jobs.find(({ file, name }) =>
    file === publishing.file && name === publishing.needs);
  assert.match(commandsOf(tested), /release\.js "\$GITHUB_REF_NAME"[^]*npm test[^]*npm pack/);
  assert.deepEqual(tested.permissions, { contents: 'read' });
  assert.ok(!publishing.steps.some(({ uses }) => /checkout/.test(uses ?? '')));
});

test('the changelog goes by versions, the newest first, each with its day', () => {
  const [first, ...versions] = sectionsOf(changelog).keys();
  assert.equal(first, '[Unreleased]');
  const numbers = versions.map((heading) => {
    const [, version, day] = /^\[(\d+\.\d+\.\d+)\] - (\d{4}-\d\d-\d\d)$/.exec(heading) ?? [];
    assert.equal(new Date(day).toISOString().slice(0, 10), day, heading);
    return version;
  });
  const newestFirst = numbers.toSorted((a, b) => b.localeCompare(a, 'en', { numeric: true }));
  assert.deepEqual(numbers, newestFirst);
  const groups = ['Added', 'Changed', 'Deprecated', 'Removed', 'Fixed', 'Security'];
  const [, ...kinds] = changelog.split(/^### /m).map((part) => part.split('\n')[0]);
  assert.deepEqual(kinds.filter((kind) => !groups.includes(kind)), []);
});

test('a release has the tag, the version, the section and the repository of one another', () => {
  const claims = { tag: 'v1.2.3', address: 'https://github.com/some/one',
    manifest: { version: '1.2.3', repository: { url: 'git+https://github.com/some/one.git' } },
    changelog: '# Log\n\n## [Unreleased]\n\n## [1.2.3] - 2026-12-24\n\n### Added\n- This.\n\n'
      + '## [1.2.2] - 2026-12-23\n\n### Added\n- That.\n' };
  assert.equal(releaseNotes(claims), '### Added\n- This.');
  const wrong = [
    [{ tag: 'v1.2.2' }, /tag is v1\.2\.2.*version 1\.2\.3/],
    [{ tag: '1.2.3' }, /tagged vX\.Y\.Z/],
    [{ tag: 'v1.2.3-a', manifest: { ...claims.manifest, version: '1.2.3-a' } }, /vX\.Y\.Z/],
    [{ address: 'https://github.com/some/two' }, /this is https:\/\/github\.com\/some\/two/],
    [{ address: undefined }, /none that GitHub names/],
    [{ manifest: { ...manifest, version: '1.2.3' } }, /Set repository, bugs and homepage/],
    [{ changelog: claims.changelog.replace('[1.2.3] - ', '[1.2.4] - ') }, /says nothing under/],
    [{ changelog: claims.changelog.replace('### Added\n- This.\n', '') }, /says nothing under/],
    [{ changelog: claims.changelog.replace('d]\n', 'd]\n- More.\n') }, /under \[Unreleased\]/],
  ];
  for (const [change, message] of wrong) {
    assert.throws(() => releaseNotes({ ...claims, ...change }), message);
  }
});

test('the program that checks a release ends with a sentence and a status', () => {
  const { status, stdout, stderr } = spawnSync(process.execPath,
    ['bindings/build/release.js', 'v0.0.0'], { cwd: root, encoding: 'utf8' });
  assert.deepEqual([status, stdout], [1, '']);
  assert.match(stderr, /^The tag is v0\.0\.0, .+\n$/);
});
