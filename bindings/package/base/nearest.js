// SPDX-License-Identifier: MIT

// The name that was probably meant by one that is not known.

/** Longer names are not compared, to save time. */
const longestName = 100;

/** Shorter words are not taken as the beginning of a name. */
const fewestLetters = 3;

/** The options that do what other tools call so; letters only, lower case. */
const words = {
  vertices: ['verts', 'vertexcount', 'numvertices', 'targetvertices', 'nvertices', 'points'],
  faces: ['polycount', 'polygons', 'polys', 'tris', 'trianglecount', 'facecount', 'numfaces',
    'numtriangles', 'targetfaces', 'targettriangles', 'targetcount', 'targetfacenum', 'count'],
  ratio: ['decimate', 'reduce', 'reduction', 'simplify', 'simplification', 'percent', 'percentage',
    'targetperc'],
  'max-error': ['tolerance', 'error', 'epsilon', 'maxdistance', 'deviation', 'hausdorff'],
  'edge-length': ['resolution', 'voxelsize', 'targetlength', 'targetedgelength', 'targetlen'],
  'drop-below': ['islands', 'minislandsize', 'floaters', 'removefloaters', 'mincomponent'],
  'feature-angle': ['crease', 'creaseangle', 'sharp', 'sharpangle', 'hardedges', 'features'],
  repair: ['fix', 'watertight', 'close', 'closeholes', 'fillholes', 'makemanifold', 'manifold',
    'heal', 'mend'],
  quads: ['quad', 'quadrangulate', 'retopo', 'retopology', 'quadremesh'],
  lods: ['levels', 'lodlevels', 'lod', 'levelsofdetail'],
  weld: ['merge', 'mergevertices', 'mergedistance', 'mergebydistance', 'removedoubles'],
  unite: ['join', 'combine', 'boolean', 'fuse'],
  compress: ['draco', 'meshopt', 'compression'],
  output: ['out', 'outfile', 'outputfile', 'dest', 'destination'],
  force: ['overwrite', 'yes'],
};

/** A name without dashes, in lower case: --target-faces, targetFaces → targetfaces. */
const plain = (/** @type {string} */ name) => name.replace(/[^a-z]/gi, '').toLowerCase();

const meantBy = new Map(Object.entries(words)
  .flatMap(([option, others]) => others.map((other) => [other, plain(option)])));

/**
 * The known name that was probably meant, or undefined: one that other tools call so, else one
 * that begins so, else one in which few letters differ.
 * @param {string} name
 * @param {readonly string[]} known
 */
export function nearest(name, known) {
  if (name.length > longestName) return undefined;
  const word = plain(name);
  const elsewhere = meantBy.get(word);
  const same = known.find((candidate) => [word, elsewhere].includes(plain(candidate)));
  if (same) return same;
  const begun = word.length >= fewestLetters
    && known.find((candidate) => plain(candidate).startsWith(word));
  if (begun) return begun;
  let best;
  let least = Math.max(1, Math.floor(word.length / 3)) + 1;
  for (const candidate of known) {
    const distance = editDistance(word, plain(candidate));
    if (distance < least) [best, least] = [candidate, distance];
  }
  return best;
}

/** @param {string} a @param {string} b */
function editDistance(a, b) {
  let row = Array.from({ length: b.length + 1 }, (_, j) => j);
  for (let i = 1; i <= a.length; i += 1) {
    const next = [i];
    for (let j = 1; j <= b.length; j += 1) {
      const change = row[j - 1] + (a[i - 1] === b[j - 1] ? 0 : 1);
      next.push(Math.min(change, row[j] + 1, next[j - 1] + 1));
    }
    row = next;
  }
  return row[b.length];
}
