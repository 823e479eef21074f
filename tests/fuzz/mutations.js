// SPDX-License-Identifier: MIT
// Ways to spoil a surface, a text, a glTF tree or bytes, chosen by dice. Each way returns a new
// value, or changes a copy that it was given.
import { openContainer, packGlb } from '../../bindings/package/codecs/gltf_container.js';

/** @typedef {import('./dice.js').Dice} Dice */

export const wildNumbers = [0, -0, 1, -1, 0.5, 1e-30, 1e-12, 1e-6, 1e6, 1e12, 1e30, -1e30, 3e38,
  1e-45, 1 + 2 ** -23, 1e300];

const triangleOf = (shape, dice) => dice.pick(shape.triangles);

/** Ways to spoil lists of positions and triangles. */
const ofShapes = {
  'wild coordinate': (shape, dice) => {
    dice.pick(shape.positions)[dice.whole(0, 2)] = dice.pick(wildNumbers);
  },
  nudge: (shape, dice) => {
    const place = dice.pick(shape.positions);
    for (let k = 0; k < 3; k += 1) place[k] += 0.3 * dice.number(-1, 1);
  },
  noise: (shape, dice) => {
    const amount = 10 ** dice.number(-6, -1);
    for (const place of shape.positions) {
      for (let k = 0; k < 3; k += 1) place[k] += amount * dice.number(-1, 1);
    }
  },
  squash: (shape, dice) => {
    const [axis, factor] = [dice.whole(0, 2), 10 ** dice.number(-9, 3)];
    for (const place of shape.positions) place[axis] *= factor;
  },
  'far away': (shape, dice) => {
    const offset = 10 ** dice.number(0, 7);
    for (const place of shape.positions) place[0] += offset;
  },
  rescale: (shape, dice) => {
    const factor = 10 ** dice.number(-30, 30);
    for (const place of shape.positions) {
      for (let k = 0; k < 3; k += 1) place[k] *= factor;
    }
  },
  pinch: (shape, dice) => {
    const place = dice.pick(shape.positions);
    const other = dice.pick(shape.positions);
    for (let k = 0; k < 3; k += 1) place[k] = other[k];
  },
  twice: (shape, dice) => shape.triangles.push([...triangleOf(shape, dice)]),
  flipped: (shape, dice) => triangleOf(shape, dice).reverse(),
  hole: (shape, dice) => {
    if (shape.triangles.length > 1) {
      shape.triangles.splice(dice.whole(0, shape.triangles.length - 1), 1);
    }
  },
  spike: (shape, dice) => {
    triangleOf(shape, dice)[dice.whole(0, 2)] = dice.whole(0, shape.positions.length - 1);
  },
  corner: (shape, dice) => {
    triangleOf(shape, dice)[0] = triangleOf(shape, dice)[1];
  },
};

/** @param {Dice} dice */
export function spoilShape({ positions, triangles }, dice, said) {
  const copied = (lists) => lists.map((list) => [...list]);
  const shape = { positions: copied(positions), triangles: copied(triangles) };
  const name = dice.pick(Object.keys(ofShapes));
  said.push(name);
  ofShapes[name](shape, dice);
  return shape;
}

const number = /-?\d+(?:\.\d+)?(?:e[-+]?\d+)?/gi;

/** The text with one of its numbers replaced. */
function withOtherNumber(text, dice) {
  const all = [...text.matchAll(number)];
  if (all.length === 0) return text;
  const { 0: old, index } = dice.pick(all);
  const others = [dice.pick(wildNumbers), Number(old) + 1, -Number(old), 'nan', 4294967296,
    dice.pick(all)[0]];
  return `${text.slice(0, index)}${dice.pick(others)}${text.slice(index + old.length)}`;
}

const ofLines = {
  'other number': withOtherNumber,
  'line lost': (text, dice) => {
    const lines = text.split('\n');
    lines.splice(dice.whole(0, lines.length - 1), 1);
    return lines.join('\n');
  },
  'line twice': (text, dice) => {
    const lines = text.split('\n');
    const line = dice.pick(lines);
    lines.splice(dice.whole(0, lines.length), 0, line);
    return lines.join('\n');
  },
  'letter': (text, dice) => {
    const at = dice.whole(0, text.length);
    const letter = dice.pick(['#', '\\', '/', '-', ' ', '\n', '\r', '\t', 'e', '\0', '9',
      '\u202e', '"', '\x1b[31m']);
    return text.slice(0, at) + letter + text.slice(at + dice.whole(0, 1));
  },
  'cut': (text, dice) => text.slice(0, dice.whole(0, text.length)),
};

export function spoilText(text, dice, said) {
  const name = dice.pick(Object.keys(ofLines));
  said.push(name);
  return ofLines[name](text, dice);
}

/** All pairs of a list or object in a tree and the key of one of its members. */
function placesIn(tree) {
  if (typeof tree !== 'object' || tree === null) return [];
  return Object.keys(tree).flatMap((key) =>
    [{ holder: tree, key }, ...placesIn(tree[key])]);
}

const wholeNumbers = [0, 1, 2, 3, 4, 7, 255, 256, 65535, 65536, 2 ** 31 - 1, 2 ** 31, 2 ** 32 - 1,
  -1, 2 ** 53];
const componentTypes = [5120, 5121, 5122, 5123, 5125, 5126, 5130];
const types = ['SCALAR', 'VEC2', 'VEC3', 'VEC4', 'MAT2', 'MAT3', 'MAT4', 'VEC5'];
const semantics = ['NORMAL', 'TANGENT', 'TEXCOORD_0', 'TEXCOORD_1', 'COLOR_0', 'JOINTS_0',
  'WEIGHTS_0', 'WEIGHTS_1', '_EXTRA'];

const ofTrees = {
  'number': (tree, dice) => {
    const numbers = placesIn(tree).filter(({ holder, key }) => typeof holder[key] === 'number');
    if (numbers.length === 0) return;
    const { holder, key } = dice.pick(numbers);
    holder[key] = dice.pick([holder[key] + 1, holder[key] - 1, dice.pick(wholeNumbers),
      dice.pick(wildNumbers)]);
  },
  'lost member': (tree, dice) => {
    const { holder, key } = dice.pick(placesIn(tree));
    if (Array.isArray(holder)) holder.splice(Number(key), 1);
    else delete holder[key];
  },
  'other type': (tree, dice) => {
    const { holder, key } = dice.pick(placesIn(tree));
    holder[key] = dice.pick([null, 'text', [], {}, true, 5, [[]]]);
  },
  'repeated': (tree, dice) => {
    const lists = placesIn(tree).filter(({ holder, key }) => Array.isArray(holder[key]));
    if (lists.length === 0) return;
    const { holder, key } = dice.pick(lists);
    holder[key].push(structuredClone(dice.pick(holder[key])) ?? 0);
  },
  'component type': (tree, dice) => {
    Object.assign(dice.pick(tree.accessors) ?? {}, { componentType: dice.pick(componentTypes) });
  },
  'accessor type': (tree, dice) => {
    Object.assign(dice.pick(tree.accessors) ?? {}, { type: dice.pick(types) });
  },
  'attribute': (tree, dice) => {
    const { attributes } = tree.meshes[0].primitives[0];
    attributes[dice.pick(semantics)] = dice.whole(0, tree.accessors.length);
  },
  'sparse': (tree, dice) => {
    const place = () => ({ bufferView: dice.whole(0, tree.bufferViews.length - 1) });
    dice.pick(tree.accessors).sparse = { count: dice.whole(0, 4), values: place(),
      indices: { ...place(), componentType: dice.pick(componentTypes) } };
  },
  'skin': (tree, dice) => {
    tree.skins = [{ joints: [dice.whole(0, tree.nodes.length)],
      inverseBindMatrices: dice.whole(0, tree.accessors.length) }];
    tree.nodes[0].skin = 0;
  },
  'node': (tree, dice) => {
    const node = dice.pick(tree.nodes);
    const three = () => [0, 1, 2].map(() => dice.pick(wildNumbers));
    Object.assign(node, dice.pick([{ scale: three() }, { translation: three() },
      { rotation: [...three(), 1] }, { children: [dice.whole(0, tree.nodes.length)] },
      { matrix: [...three(), 0, ...three(), 0, ...three(), 0, ...three(), 1] }]));
  },
};

/** Spoils a tree in place. A tree that is already too broken is not changed. */
export function spoilTree(tree, dice, said) {
  const name = dice.pick(Object.keys(ofTrees));
  said.push(name);
  try {
    ofTrees[name](tree, dice);
  } catch (error) {
    if (!(error instanceof TypeError)) throw error;
  }
}

/** Spoils a bit, a byte, or a float in place. */
export function spoilBytes(bytes, dice, said) {
  if (bytes.length < 4) return;
  said.push('bytes');
  const at = dice.whole(0, bytes.length - 1);
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  switch (dice.whole(0, 2)) {
    case 0:
      bytes[at] ^= 1 << dice.whole(0, 7);
      break;
    case 1:
      bytes[at] = dice.pick([0, 1, 127, 128, 255]);
      break;
    default:
      view.setFloat32(Math.min(at - (at % 4), bytes.length - 4),
        dice.pick([...wildNumbers, NaN, Infinity]), true);
  }
}

/** A GLB, packed again after its tree or its buffer was spoilt. */
function spoilGlb(bytes, dice, said) {
  const { text, chunk = new Uint8Array() } = openContainer(bytes);
  const tree = JSON.parse(text);
  const data = chunk.slice();
  if (dice.chance(0.6)) spoilTree(tree, dice, said);
  else spoilBytes(data, dice, said);
  return packGlb(tree, data);
}

function spoilGltf(bytes, dice, said) {
  const tree = JSON.parse(new TextDecoder().decode(bytes));
  spoilTree(tree, dice, said);
  return new TextEncoder().encode(JSON.stringify(tree));
}

/** The file with a fault in the terms of its format; at times with spoilt bytes. */
export function spoilFile(file, dice, said) {
  const bytes = file.bytes.slice();
  if (dice.chance(0.1)) {
    spoilBytes(bytes, dice, said);
    return { ...file, bytes };
  }
  const isText = !/\.gl(b|tf)$/.test(file.name);
  if (isText) {
    const text = spoilText(new TextDecoder().decode(bytes), dice, said);
    return { ...file, bytes: new TextEncoder().encode(text) };
  }
  try {
    const spoil = file.name.endsWith('.glb') ? spoilGlb : spoilGltf;
    return { ...file, bytes: spoil(bytes, dice, said) };
  } catch (error) {
    if (!(error instanceof SyntaxError)) throw error;
    spoilBytes(bytes, dice, said);
    return { ...file, bytes };
  }
}
