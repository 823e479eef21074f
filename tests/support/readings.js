// SPDX-License-Identifier: MIT
// Which files of the checkout a test file can read: itself, what it imports, and whatever its text
// or that of such a file names by a path, from the root or from where it stands. Of a folder that
// is all that lies in it, but for programs that are made of the checkout, which go by their whole
// names; of our package what its exports lead to.
import { dirname, join, normalize } from 'node:path';

/** Declarations speak of each other by the names of the scripts. */
const isTypes = /\.d\.m?ts$/;
/** What leads on: programs, recipes, which are some, and the papers at the root by their links. */
const leadsOn = /^(?!package).*\.(m?[jt]s|json|html|css|sh)$|^docs\/recipes\/|^\w+\.md$/;
const isPaper = /^\w+\.md$/;

/**
 * Whatever looks like a path, and single words if they are quoted, but for the part of the build
 * that is called as a folder is; comments read nothing.
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

/** Every folder with the files of ours in it, however deep. @param {readonly string[]} files */
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

/** By the name it is imported by: where an entry of the package leads. @param {any} manifest */
function entriesOf({ name, exports }) {
  const targets = (/** @type {any} */ entry) => (typeof entry === 'string'
    ? [normalize(entry)] : Object.values(entry).flatMap(targets));
  return new Map(Object.entries(exports)
    .map(([path, entry]) => [join(name, path), targets(entry)]));
}

/**
 * @param {readonly string[]} files all that may be read, by their paths from the root
 * @param {(file: string) => string} read
 * @returns {(file: string) => string[]} of a file what it can read, sorted
 */
export function readings(files, read) {
  const all = new Set(files);
  const folders = foldersOf(files);
  /** By npm, which is called from the root: the package, and the papers beside it. */
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
