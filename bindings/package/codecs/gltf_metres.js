// SPDX-License-Identifier: MIT
// Lengths of glTF are metres: a model of another format whose unit is known keeps its numbers, and
// a node above its roots says how long they are.

import { isGltf } from '../base/contents.js';
import { metresIn, unitOf } from '../base/lengths.js';
import { openContainer, packGlb } from './gltf_container.js';

/** @typedef {import('../base/messages.js').FileRequest} FileRequest */
/** @typedef {import('../base/messages.js').NamedBytes} NamedBytes */

/** The scenes of a glTF file below one more node each, of this scale.
 * @param {any} tree the file's JSON @param {number} scale */
function scaled(tree, scale) {
  const nodes = [...tree.nodes];
  const scenes = tree.scenes.map((/** @type {any} */ scene) => {
    if (!scene.nodes?.length) return scene;
    nodes.push({ name: 'metres', scale: [scale, scale, scale], children: scene.nodes });
    return { ...scene, nodes: [nodes.length - 1] };
  });
  return { ...tree, nodes, scenes };
}

/**
 * The files of a result, a glTF among them in metres.
 * @param {NamedBytes[]} files the model first
 * @param {FileRequest | undefined} source the file whose lengths it has, unpacked
 * @param {unknown} units that were said
 * @returns {NamedBytes[]}
 */
export function inMetres([model, ...others], source, units) {
  const isAsked = source?.isInMetres !== false && /\.gl(b|tf)$/i.test(model.name);
  if (!source || !isAsked || isGltf(source.bytes)) return [model, ...others];
  const unit = unitOf({ units }, source);
  if (unit === undefined || unit === 'm') return [model, ...others];
  const { text, chunk } = openContainer(model.bytes);
  const tree = scaled(JSON.parse(text), metresIn(unit));
  const bytes = chunk ? packGlb(tree, chunk) : new TextEncoder().encode(JSON.stringify(tree));
  return [{ ...model, bytes }, ...others];
}
