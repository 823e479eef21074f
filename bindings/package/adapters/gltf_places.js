// SPDX-License-Identifier: MIT
// Where the scene of a glTF-Transform document shows its meshes.

import { MathUtils } from '@gltf-transform/core';

/** @import { Document, Mesh, Node, mat4, vec3, vec4 } from '@gltf-transform/core' */

/** @param {ArrayLike<number>} a @param {ArrayLike<number>} b @returns {number[]} affine ones */
function product(a, b) {
  return Array.from({ length: 16 }, (_, i) => {
    const [row, column] = [i % 4, 4 * Math.floor(i / 4)];
    if (row === 3) return Number(i === 15);
    return [0, 1, 2, 3].reduce((sum, k) => sum + a[4 * k + row] * b[column + k], 0);
  });
}

const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/** The nodes of the scene shown first; all if there is no scene. @param {Document} document */
function shownNodes(document) {
  const root = document.getRoot();
  const scene = root.getDefaultScene() ?? root.listScenes()[0];
  if (!scene) return root.listNodes();
  /** @type {Node[]} */
  const nodes = [];
  scene.traverse((node) => void nodes.push(node));
  return nodes;
}

/** Where the first joint carries a skinned mesh at rest; usually all joints agree.
 * @param {import('@gltf-transform/core').Skin} skin @param {Set<Node>} shown */
function skinnedPlace(skin, shown) {
  const [joint] = skin.listJoints();
  if (!joint || !shown.has(joint)) return identity;
  const inverse = skin.getInverseBindMatrices()?.getElement(0, []) ?? identity;
  return product(joint.getWorldMatrix(), inverse);
}

/** @param {any} batch EXT_mesh_gpu_instancing @returns {number[][]} */
function instances(batch) {
  const [translations, rotations, scales] = ['TRANSLATION', 'ROTATION', 'SCALE']
    .map((semantic) => batch.getAttribute(semantic));
  const count = (translations ?? rotations ?? scales)?.getCount() ?? 0;
  return Array.from({ length: count }, (_, i) => MathUtils.compose(
    /** @type {vec3} */ (translations?.getElement(i, []) ?? [0, 0, 0]),
    /** @type {vec4} */ (rotations?.getElement(i, []) ?? [0, 0, 0, 1]),
    /** @type {vec3} */ (scales?.getElement(i, []) ?? [1, 1, 1]),
    /** @type {mat4} */ ([...identity])));
}

/**
 * @param {Document} document
 * @returns {Map<Mesh, number[][]>} matrices from its own space to the world
 */
export function placesOfMeshes(document) {
  const shown = new Set(shownNodes(document));
  /** @type {Map<Mesh, number[][]>} */
  const places = new Map();
  for (const node of shown) {
    const [mesh, skin] = [node.getMesh(), node.getSkin()];
    if (!mesh) continue;
    const batch = node.getExtension('EXT_mesh_gpu_instancing');
    const own = skin ? skinnedPlace(skin, shown) : node.getWorldMatrix();
    const all = batch ? instances(batch) : [identity];
    places.set(mesh, [...places.get(mesh) ?? [], ...all.map((instance) => product(own, instance))]);
  }
  return places;
}
