// SPDX-License-Identifier: MIT
// Reads surfaces from PLY (text and both binary orders) and STL (binary and text), without the
// engine.
import { readStlText } from './read_text.js';

const sizes = { char: 1, int8: 1, uchar: 1, uint8: 1, short: 2, int16: 2, ushort: 2, uint16: 2,
  int: 4, int32: 4, uint: 4, uint32: 4, float: 4, float32: 4, double: 8, float64: 8 };
const getters = { char: 'getInt8', int8: 'getInt8', uchar: 'getUint8', uint8: 'getUint8',
  short: 'getInt16', int16: 'getInt16', ushort: 'getUint16', uint16: 'getUint16',
  int: 'getInt32', int32: 'getInt32', uint: 'getUint32', uint32: 'getUint32',
  float: 'getFloat32', float32: 'getFloat32', double: 'getFloat64', float64: 'getFloat64' };

/** @param {Uint8Array} bytes */
const viewOf = (bytes) => new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);

function plyHeader(text) {
  const end = /end_header\r?\n/.exec(text);
  if (!end) throw new Error('no end_header');
  const header = { format: '', elements: [], length: end.index + end[0].length };
  for (const line of text.slice(0, end.index).split(/\r?\n/)) {
    const words = line.trim().split(/\s+/);
    if (words[0] === 'format') header.format = words[1];
    if (words[0] === 'element') {
      header.elements.push({ name: words[1], count: Number(words[2]), properties: [] });
    }
    if (words[0] === 'property') {
      const list = words[1] === 'list';
      header.elements.at(-1).properties.push(
        { name: words.at(-1), type: list ? words[3] : words[1], count: list ? words[2] : '' });
    }
  }
  return header;
}

/** Takes one number after the other out of the words of a text. */
function wordsAfter(text) {
  const words = text.trim().split(/\s+/);
  let at = 0;
  return (type) => {
    const value = Number(words[at]);
    at += 1;
    return /^(float|float32)$/.test(type) ? Math.fround(value) : value;
  };
}

/** Takes one number after the other out of bytes. */
function numbersAfter(bytes, start, little) {
  const view = viewOf(bytes);
  let at = start;
  return (type) => {
    const value = view[getters[type]](at, little);
    at += sizes[type];
    return value;
  };
}

function plyRow(properties, next) {
  const row = {};
  for (const { name, type, count } of properties) {
    row[name] = count ? Array.from({ length: next(count) }, () => next(type)) : next(type);
  }
  return row;
}

/** Properties of vertices and faces, by what they are. */
const plyNames = { nx: 'NORMAL', red: 'COLOR_0', s: 'TEXCOORD_0', u: 'TEXCOORD_0',
  texture_u: 'TEXCOORD_0', texcoord: 'TEXCOORD_0', texnumber: 'materials' };

/** See figures.js for `holds`. @param {Uint8Array} bytes */
export function readPly(bytes) {
  const text = Buffer.from(bytes.subarray(0, 65536)).toString('latin1');
  const { format, elements, length } = plyHeader(text);
  const next = format === 'ascii'
    ? wordsAfter(Buffer.from(bytes.subarray(length)).toString('latin1'))
    : numbersAfter(bytes, length, format === 'binary_little_endian');
  let positions = new Float64Array();
  let faces = [];
  for (const { name, count, properties } of elements) {
    const rows = Array.from({ length: count }, () => plyRow(properties, next));
    if (name === 'vertex') positions = Float64Array.from(rows.flatMap(({ x, y, z }) => [x, y, z]));
    if (name === 'face') faces = rows.map((row) => row.vertex_indices ?? row.vertex_index);
  }
  const holds = new Set(elements.flatMap(({ properties }) =>
    properties.flatMap(({ name }) => plyNames[name] ?? [])));
  return { parts: [{ name: '', positions, faces }], holds };
}

/** Each facet has vertices of its own. @param {Uint8Array} bytes */
export function readStl(bytes) {
  const view = viewOf(bytes);
  const count = bytes.length >= 84 ? view.getUint32(80, true) : -1;
  if (bytes.length !== 84 + 50 * count) {
    return readStlText(Buffer.from(bytes).toString('latin1'));
  }
  const positions = new Float64Array(9 * count);
  for (let i = 0; i < positions.length; i += 1) {
    const at = 84 + 50 * Math.floor(i / 9) + 12 + 4 * (i % 9);
    positions[i] = view.getFloat32(at, true);
  }
  const faces = Array.from({ length: count }, (_, t) => [3 * t, 3 * t + 1, 3 * t + 2]);
  return { parts: [{ name: '', positions, faces }] };
}
