// SPDX-License-Identifier: MIT
// Reads surfaces from text, without the engine: OBJ, OFF, and the bodies of PLY and STL in text.
// A part is { name, positions, faces }: three numbers a vertex, a list of vertices for each face.

/** @typedef {{ name: string, positions: Float64Array, faces: number[][] }} FacePart */

/** @param {string} text @returns {string[][]} the words of each line; comments are left out */
const linesOf = (text) => text.split(/\r?\n/)
  .map((line) => line.replace(/#.*$/, '').trim()).filter(Boolean)
  .map((line) => line.split(/\s+/));

/** A vertex of OBJ: from 1, or from the last one backwards. */
function objIndex(word, count) {
  const number = parseInt(word, 10);
  const index = number < 0 ? count + number : number - 1;
  if (!(index >= 0 && index < count)) throw new Error(`vertex ${word} of ${count}`);
  return index;
}

/** One part for the whole file: groups and objects share their vertices. The names of the materials
 * that faces use are in `materials`; see figures.js for `holds`. @param {string} text */
export function readObj(text) {
  const positions = [];
  const faces = [];
  const materials = new Set();
  const holds = new Set();
  const joined = text.replace(/\\\r?\n/g, ' ');
  let material;
  for (const [key, ...words] of linesOf(joined)) {
    if (key === 'v') {
      positions.push(...words.slice(0, 3).map(Number));
      if (words.length > 4) holds.add('COLOR_0');
    }
    if (key === 'usemtl') material = words.join(' ');
    if (key !== 'f') continue;
    if (material) materials.add(material);
    if (/^\d+\/\d/.test(words[0])) holds.add('TEXCOORD_0');
    if (/\/\d*\/\d/.test(words[0])) holds.add('NORMAL');
    faces.push(words.map((word) => objIndex(word, positions.length / 3)));
  }
  if (materials.size > 0) holds.add('materials');
  if (materials.size > 0 && /^\s*mtllib\s/m.test(text)) holds.add('looks');
  const part = { name: '', positions: Float64Array.from(positions), faces };
  return { parts: [part], materials, holds };
}

/** OFF with whatever follows a position (colours, normals, texture coordinates). */
export function readOff(text) {
  const lines = linesOf(text);
  const [keyword, ...rest] = lines[0];
  if (!/OFF$/.test(keyword)) throw new Error(`"${keyword}" is not OFF`);
  const [counts, first] = rest.length > 0 ? [rest, 1] : [lines[1], 2];
  const [vertices, faceCount] = counts.map(Number);
  const rows = lines.slice(first, first + vertices);
  // NOFF, COFF and STOFF all write the position first; 4OFF is not written.
  const positions = Float64Array.from(rows.flatMap((row) => row.slice(0, 3).map(Number)));
  const faces = lines.slice(first + vertices, first + vertices + faceCount)
    .map((row) => row.slice(1, 1 + Number(row[0])).map(Number));
  if (faces.length !== faceCount) throw new Error(`${faces.length} of ${faceCount} faces`);
  const letters = { COLOR_0: 'C', NORMAL: 'N', TEXCOORD_0: 'ST' };
  const holds = new Set(Object.keys(letters).filter((name) => keyword.includes(letters[name])));
  return { parts: [{ name: '', positions, faces }], holds };
}

/** STL in text: each facet has vertices of its own. */
export function readStlText(text) {
  const numbers = [...text.matchAll(/^\s*vertex\s+(\S+)\s+(\S+)\s+(\S+)/gm)];
  const positions = Float64Array.from(numbers.flatMap(([, ...xyz]) => xyz.map(Number)));
  const faces = Array.from({ length: numbers.length / 3 }, (_, t) => [3 * t, 3 * t + 1, 3 * t + 2]);
  return { parts: [{ name: '', positions, faces }] };
}
