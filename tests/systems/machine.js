// SPDX-License-Identifier: MIT
// How this computer reaches the network, so that a system inside it can: proxies, mirrors,
// certificates, npm's registry. It is asked for, not assumed; what logs somebody in stays here.
import { spawnSync } from 'node:child_process';
import { copyFileSync, cpSync, existsSync, mkdirSync, statSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';

/** @param {string} command @param {readonly string[]} words @returns {string} what it prints */
function answer(command, words) {
  const { status, stdout } = spawnSync(command, words, { encoding: 'utf8' });
  return status === 0 ? stdout.trim() : '';
}

/** Variables that name proxies, and those that name a file of certificates. */
const namesProxy = /^(https?|ftp|all|no)_proxy$/i;
const namesCertificates = /(_CERTS?|_CERT_FILE|_CA_BUNDLE|_CAINFO|_CA_CERTS_FILE)$|_CA_CERTS$/;

/** @param {string | undefined} path */
const isFile = (path) => Boolean(path) && existsSync(path) && statSync(path).isFile();

/** What of the environment the network is reached by. @returns {Record<string, string>} */
export function networkVariables() {
  const found = Object.entries(process.env).filter(([name, value]) => namesProxy.test(name)
    || (namesCertificates.test(name) && isFile(value)));
  return /** @type {Record<string, string>} */ (Object.fromEntries(found));
}

/** Where this computer takes Debian's packages from; nothing where it does not. */
export function debianMirror() {
  const words = ['indextargets', '--format', '$(ORIGIN) $(SUITE) $(REPO_URI)',
    'Created-By: Packages'];
  const lines = answer('apt-get', words).split('\n').map((line) => line.split(' '));
  const [, , mirror] = lines.find(([origin, suite, address]) =>
    origin === 'Debian' && !/-(security|updates|backports)/.test(suite) && address) ?? [];
  return mirror;
}

/** @param {string} place a file of the new system @param {string} text */
function write(place, text) {
  mkdirSync(dirname(place), { recursive: true });
  writeFileSync(place, text);
}

/** How apt downloads. @param {string} folder */
function copyAptSettings(folder) {
  const names = ['Acquire::http', 'Acquire::https', 'Acquire::Retries',
    'Acquire::Check-Valid-Until', 'Acquire::Check-Date', 'APT::Sandbox::User'];
  write(join(folder, 'etc/apt/apt.conf.d/90machine'), `${answer('apt-config', ['dump', ...names])}
`);
}

/** npm's registry, proxies and certificates. @param {string} folder */
function copyNpmSettings(folder) {
  const names = ['registry', 'cafile', 'proxy', 'https-proxy', 'noproxy', 'strict-ssl'];
  const lines = names.map((name) => [name, answer('npm', ['config', 'get', name])])
    .filter(([, value]) => value && value !== 'null' && value !== 'undefined')
    .map(([name, value]) => `${name}=${value}\n`);
  write(join(folder, 'root/.npmrc'), lines.join(''));
}

/** Certificates of this computer's own, and each bundle under its path. @param {string} folder */
function copyCertificates(folder) {
  const own = '/usr/local/share/ca-certificates';
  if (existsSync(own)) cpSync(own, join(folder, own), { recursive: true });
  const bundles = [...Object.entries(networkVariables())
    .filter(([name]) => !namesProxy.test(name)).map(([, path]) => path),
  answer('npm', ['config', 'get', 'cafile'])].filter(isFile);
  for (const path of new Set(bundles)) {
    mkdirSync(dirname(join(folder, path)), { recursive: true });
    copyFileSync(path, join(folder, path));
  }
}

/** Lets the system below a folder reach what this one reaches. @param {string} folder */
export function copyNetworkSettings(folder) {
  for (const file of ['/etc/resolv.conf', '/etc/hosts']) {
    if (isFile(file)) copyFileSync(file, join(folder, file));
  }
  copyAptSettings(folder);
  copyNpmSettings(folder);
  copyCertificates(folder);
}
