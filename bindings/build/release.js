// SPDX-License-Identifier: MIT
// Checks that the checkout agrees with a tag, before it is published:
//   node bindings/build/release.js v1.2.3
// prints that version's section of CHANGELOG.md, the release's notes, or says what does not agree.
// GitHub's variables name the repository: npm accepts a signed package only from the repository
// that its manifest names.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

import { BuildError, root, say } from './say.js';

/**
 * @typedef {object} Claims
 * @property {string} tag
 * @property {string | undefined} address of the repository, as a browser opens it
 * @property {{ version: string, repository: { url: string } }} manifest
 * @property {string} changelog
 */

/**
 * The sections' texts by their headings, `[1.2.3] - 2026-12-24` or `[Unreleased]`.
 * @param {string} changelog
 */
export function sectionsOf(changelog) {
  const [, ...sections] = changelog.split(/^## /m);
  return new Map(sections.map((section) => {
    const [heading, ...lines] = section.split('\n');
    return [heading, lines.join('\n').trim()];
  }));
}

/** @param {Claims} claims @returns {string} the notes */
export function releaseNotes({ tag, address, manifest, changelog }) {
  const { version, repository } = manifest;
  if (!/^\d+\.\d+\.\d+$/.test(version) || tag !== `v${version}`) {
    throw new BuildError(`The tag is ${tag}, and package.json has the version ${version}: a `
      + 'release is tagged vX.Y.Z.');
  }
  if (repository.url !== `git+${address}.git`) {
    throw new BuildError(`package.json says that the repository is ${repository.url}, and this is `
      + `${address ?? 'none that GitHub names'}. Set repository, bugs and homepage there.`);
  }
  const sections = sectionsOf(changelog);
  if (sections.get('[Unreleased]')) {
    throw new BuildError('CHANGELOG.md has changes under [Unreleased]. Move them to the version.');
  }
  const [, notes] = [...sections].find(([heading]) =>
    heading.startsWith(`[${version}] - `)) ?? [];
  if (!notes) {
    throw new BuildError(`CHANGELOG.md says nothing under a heading [${version}] - YYYY-MM-DD.`);
  }
  return notes;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const { GITHUB_SERVER_URL: server, GITHUB_REPOSITORY: name } = process.env;
  const read = (/** @type {string} */ file) => readFileSync(join(root, file), 'utf8');
  try {
    console.log(releaseNotes({
      tag: process.argv[2] ?? '', address: server && name && `${server}/${name}`,
      manifest: JSON.parse(read('package.json')), changelog: read('CHANGELOG.md'),
    }));
  } catch (error) {
    if (!(error instanceof BuildError)) throw error;
    say(error.message);
    process.exitCode = 1;
  }
}
