// SPDX-License-Identifier: MIT
// Finds the files of the checkout that a test file can read: the file itself, its imports, and
// every path that its text or the text of such a file names, from the root or from the file's
// folder. A named folder means all files in it, except programs built from the checkout, which must
// be named in full. Our package's name means the files of its exports.
import { dirname, join, normalize } from 'node:path';

/** Declarations import each other by the names of the scripts. */
const isTypes = /\.d\.m?ts$/;
/** Files that name other files: programs, recipes, which contain programs, and papers at the root,
 * by their links. */
const leadsOn = /^(?!package).*\.(m?[jt]s|json|html|css|sh)$|^docs\/recipes\/|^\w+\.md$/;
const isPaper = /^\w+\.md$/;

/**
 * Every text that looks like a path, and quoted single words. In the build the word 'tests' is a
 * part, not the folder. Comments do not count.
 * @param {string} file @param {string} whole
 */
function pathsIn(file, whole) {
  if (isPaper.test(file)) return new Set(whole.match(/(?<=\]\()[^)#]+/g));
  const text = whole.replace(/^ *\/\*\*[\s\S]*?\*\/|^ *\/\/.*/gm, '');
  const paths = (text.match(/[\w@.-]*[./][\w@./-]*/g) ?? [])
    .filter((path) => /\w/.test(path) && !/\w.*\/\.\./.test(path));
  const words = [...text.matchAll(/(['"`])([\w@-]+)\1/g)].map(([, , word]) => word)
    .filter((word) => word !== 'tests' || !file.startsWith('bindings/build'));
  return new Set([...paths, ...words]);
}

/** Every folder with all our files below it. @param {readonly string[]} files */
function foldersOf(files) {
  /** @type {Map<string, string[]>} */
  const folders = new Map();
  for (const file of files.filter((path) => !path.startsWith('build/'))) {
    for (let at = dirname(file); at !== '.'; at = dirname(at)) {
      if (!folders.has(at)) folders.set(at, []);
      folders.get(at)?.push(file);
    }
  }
  return folders;
}

/** The files of the package's entries, by import name. @param {any} manifest */
function entriesOf({ name, exports }) {
  const targets = (/** @type {any} */ entry) => (typeof entry === 'string'
    ? [normalize(entry)] : Object.values(entry).flatMap(targets));
  return new Map(Object.entries(exports)
    .map(([path, entry]) => [join(name, path), targets(entry)]));
}

/**
 * @param {readonly string[]} files that may be read, by their paths from the root
 * @param {(file: string) => string} read
 * @returns {(file: string) => string[]} the files that a file can read, sorted
 */
export function readings(files, read) {
  const all = new Set(files);
  const folders = foldersOf(files);
  /** The files that npm reads, called from the root: the package, and the papers beside it. */
  const packed = files.filter((file) => file.startsWith('dist/') || !file.includes('/'));
  const entries = entriesOf(JSON.parse(read('package.json')));
  /** @type {Map<string, string[]>} */
  const known = new Map();

  /** @param {string} file */
  function named(file) {
    if (!leadsOn.test(file)) return [];
    return [...pathsIn(file, read(file))].flatMap((path) => {
      if (path === 'npm') return packed;
      const places = [join(dirname(file), path), normalize(path.replace(/^\//, ''))]
        .map((place) => place.replace(/\/$/, ''))
        .map((place) => (isTypes.test(file) ? place.replace(/(m?)js$/, 'd.$1ts') : place));
      return places.flatMap((place) =>
        entries.get(place) ?? (all.has(place) ? [place] : folders.get(place) ?? []));
    });
  }

  return (file) => {
    const found = new Set([file, 'package.json']);
    for (const at of found) {
      if (!known.has(at)) known.set(at, named(at));
      for (const other of known.get(at) ?? []) found.add(other);
    }
    return [...found].sort();
  };
}
