// SPDX-License-Identifier: MIT
// Guides from a file: the lines of an OBJ file (`l`, `curv` is not read), or the line primitives of
// a glTF file, where its nodes place them. The name of the group or the node may hold the word
// direction or loop, which decides what the line is; otherwise a closed line is a loop.

import { isGltf } from '../base/contents.js';
import { RemeshError } from '../base/errors.js';
import { isReturning } from '../base/guides.js';
import { legible } from '../base/legible.js';
import { loadBuffers, slice } from './buffer_views.js';
import { openContainer } from './gltf_container.js';
import { GltfData } from './gltf_data.js';

/** @typedef {import('../base/guides.js').FlatGuide} FlatGuide */
/** @typedef {import('../base/messages.js').NamedBytes} NamedBytes */
/** @typedef {{ name: string, points: number[][], isClosed?: boolean }} Line */

/** @param {string} file @param {string} why @returns {RemeshError} */
function unread(file, why) {
  return new RemeshError('PARSE_ERROR', `${legible(file)}: ${why}.`,
    'Give guides as lines of an OBJ file, or as line primitives of a glTF file.');
}

/** The kind that a line's name gives; undefined: none. @param {string} name */
function kindIn(name) {
  const [word] = /direction|loop/i.exec(name) ?? [];
  return /** @type {'direction' | 'loop' | undefined} */ (word?.toLowerCase());
}

/** @param {Line} line @param {number} number @returns {FlatGuide} */
function guideOf({ name, points, isClosed = false }, number) {
  const closed = isClosed ? [...points, points[0]] : points;
  const flat = Float64Array.from(closed.flat());
  const kind = kindIn(name) ?? (isReturning(flat) ? 'loop' : 'direction');
  return { points: flat, kind, name: name ? legible(name) : String(number) };
}

/** Joins lines that begin where the one before ends: programs write a side at a time.
 * @param {Line[]} lines */
function joined(lines) {
  /** @type {Line[]} */
  const whole = [];
  for (const { name, points } of lines) {
    const last = whole.at(-1);
    const isNext = last?.name === name
      && [0, 1, 2].every((axis) => last?.points.at(-1)?.[axis] === points[0][axis]);
    if (isNext) last?.points.push(...points.slice(1));
    else whole.push({ name, points: [...points] });
  }
  return whole;
}

/** @param {string} file @param {Uint8Array} bytes @returns {Line[]} */
function objLines(file, bytes) {
  /** @type {number[][]} */
  const places = [];
  /** @type {Line[]} */
  const lines = [];
  let name = '';
  const text = new TextDecoder().decode(bytes).replace(/\\\r?\n/g, ' ');
  for (const [row, content] of text.split('\n').entries()) {
    const [word, ...rest] = content.trim().split(/\s+/);
    if (word === 'v') places.push(rest.slice(0, 3).map(Number));
    if (word === 'o' || word === 'g') name = rest.join(' ');
    if (word !== 'l') continue;
    const points = rest.map((corner) => {
      const number = Number.parseInt(corner, 10);
      const place = places[number < 0 ? places.length + number : number - 1];
      if (place?.length === 3 && place.every(Number.isFinite)) return place;
      throw unread(file, `line ${row + 1} names vertex ${legible(corner)}, which is not there`);
    });
    if (points.length < 2) throw unread(file, `line ${row + 1} has fewer than two points`);
    lines.push({ name, points });
  }
  return joined(lines);
}

/** The product of two matrices, column after column. @param {number[]} a @param {number[]} b */
function product(a, b) {
  return Array.from({ length: 16 }, (_, i) => [0, 1, 2, 3].reduce(
    (sum, k) => sum + a[4 * k + (i % 4)] * b[4 * Math.floor(i / 4) + k], 0));
}

/** @param {any} node @returns {number[]} */
function matrixOf({ matrix, translation = [0, 0, 0], rotation = [0, 0, 0, 1], scale = [1, 1, 1] }) {
  if (matrix) return matrix;
  const [x, y, z, w] = rotation;
  const columns = [
    [1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)],
    [2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)],
    [2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)]];
  return [...columns.flatMap((column, i) => [...column.map((value) => value * scale[i]), 0]),
    ...translation, 1];
}

/** @param {number[]} m @param {number[]} p */
const placed = (m, [x, y, z]) =>
  [0, 1, 2].map((i) => m[i] * x + m[4 + i] * y + m[8 + i] * z + m[12 + i]);

const lineModes = { pairs: 1, loop: 2, strip: 3 };

/** The numbers of the points in order. @param {GltfData} data @param {any} primitive */
function orderOf(data, { indices, attributes }) {
  const { count } = data.tree.accessors[attributes.POSITION];
  if (indices === undefined) return Array.from({ length: count }, (_, i) => i);
  const { buffer } = data.rows(indices);
  const width = data.rowOf(indices);
  return Array.from(width === 1 ? new Uint8Array(buffer)
    : width === 2 ? new Uint16Array(buffer) : new Uint32Array(buffer));
}

/**
 * The lines of a primitive, in the space of its mesh.
 * @param {GltfData} data @param {any} primitive @param {string} name @returns {Line[]}
 */
function primitiveLines(data, primitive, name) {
  const { POSITION } = primitive.attributes;
  const floats = data.floats(POSITION);
  const points = orderOf(data, primitive).map((i) => [...floats.subarray(3 * i, 3 * i + 3)]);
  if (primitive.mode !== lineModes.pairs) {
    return [{ name, points, isClosed: primitive.mode === lineModes.loop }];
  }
  const count = Math.floor(points.length / 2);
  return joined(Array.from({ length: count },
    (_, i) => ({ name, points: points.slice(2 * i, 2 * i + 2) })));
}

/** @param {any} primitive @param {GltfData} data */
function isReadable({ attributes, indices }, data) {
  return attributes?.POSITION !== undefined && data.isFloats(attributes.POSITION)
    && (indices === undefined || data.isPlain(indices));
}

/**
 * @param {string} file @param {Uint8Array} bytes @param {NamedBytes[]} resources
 * @returns {Line[]}
 */
function gltfLines(file, bytes, resources) {
  const { text, chunk } = openContainer(bytes);
  const tree = JSON.parse(text);
  const buffers = loadBuffers(tree, chunk, { name: file, resources });
  const data = new GltfData(tree, (tree.bufferViews ?? []).map(
    (/** @type {any} */ view) => slice(buffers[view.buffer], view)));
  /** @type {Line[]} */
  const lines = [];
  /** @param {number} number @param {number[]} above @param {number} depth */
  const visit = (number, above, depth) => {
    const node = tree.nodes[number];
    const place = product(above, matrixOf(node));
    const mesh = tree.meshes?.[node.mesh];
    const name = node.name ?? mesh?.name ?? '';
    for (const primitive of mesh?.primitives ?? []) {
      if (!Object.values(lineModes).includes(primitive.mode)) continue;
      if (!isReadable(primitive, data)) throw unread(file, 'its lines are compressed or sparse');
      lines.push(...primitiveLines(data, primitive, name).map((line) =>
        ({ ...line, points: line.points.map((point) => placed(place, point)) })));
    }
    if (depth > 100) return;
    for (const child of node.children ?? []) visit(child, place, depth + 1);
  };
  const unit = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  const scene = tree.scenes?.[tree.scene ?? 0];
  for (const root of scene?.nodes ?? []) visit(root, unit, 0);
  return lines;
}

/**
 * The guides of a file.
 * @param {NamedBytes} file @param {NamedBytes[]} [resources] the files that it refers to
 * @returns {FlatGuide[]}
 */
export function guidesFrom({ name, bytes }, resources = []) {
  /** @type {Line[]} */
  let lines;
  try {
    lines = isGltf(bytes) ? gltfLines(name, bytes, resources) : objLines(name, bytes);
  } catch (error) {
    if (error instanceof RemeshError) throw error;
    throw unread(name, 'it is no file of lines that can be read');
  }
  if (lines.length === 0) throw unread(name, 'there is no line in it');
  return lines.map((line, i) => guideOf(line, i + 1));
}
