// SPDX-License-Identifier: MIT
// Bodies of a surface that was read without the engine: closed pieces, the points inside them, and
// whether anything is wrong with the surface.
import { BoxTree } from './box_tree.js';
import { cornersOf, degenerateOf, edgesOf, endsOf, piecesOf, placeOf, volumeOf }
  from './surface.js';

/** Directions that no modelled edge or plane has. */
const directions = [[0.5377, 0.6233, 0.5678], [-0.7213, 0.3371, 0.6050], [0.2239, -0.8467, 0.4827]];

/** Closed pieces: of each edge as many triangles go one way as the other. Each is a list of its
 * triangles. @param {import('./surface.js').Surface} surface @returns {number[][]} */
export function closedPieces(surface) {
  const edges = edgesOf(surface);
  const isUneven = new Set();
  for (const [key, list] of edges) {
    const [low, high] = endsOf(key);
    const turns = list.reduce((sum, t) => sum + turnAt(surface, t, [low, high]), 0);
    if (turns !== 0) list.forEach((t) => isUneven.add(t));
  }
  return piecesOf(surface, edges).filter((own) => !own.some((t) => isUneven.has(t)));
}

/** 1 where a triangle goes from the one end to the other, −1 where back. */
function turnAt({ triangles }, t, [low, high]) {
  const corners = [...triangles.subarray(3 * t, 3 * t + 3)];
  const k = corners.findIndex((v, i) => v === low && corners[(i + 1) % 3] === high);
  return k >= 0 ? 1 : -1;
}

/** A tree of some triangles.
 * @param {import('./surface.js').Surface} surface @param {number[]} own */
export function treeOf(surface, own) {
  const corners = cornersOf(surface);
  const some = new Float64Array(9 * own.length);
  own.forEach((t, i) => some.set(corners.subarray(9 * t, 9 * t + 9), 9 * i));
  return new BoxTree(some);
}

/** How often closed surfaces are around a point: the middle of what three rays say.
 * @param {BoxTree} tree @param {number[]} p */
export const windingAt = (tree, p) =>
  directions.map((direction) => tree.winding(p, direction)).sort((a, b) => a - b)[1];

/** Points inside some triangles and in the matter of the whole, about `wanted`.
 * @param {{ tree: BoxTree, matter: BoxTree }} trees of the body, and of all closed pieces
 * @param {import('../../fuzz/dice.js').Dice} dice @param {number} wanted */
export function pointsIn({ tree, matter }, dice, wanted) {
  const points = [];
  const { box } = tree.nodes[0];
  for (let tries = 0; tries < 40 * wanted && points.length < wanted; tries += 1) {
    const p = [0, 1, 2].map((k) => dice.number(box[k], box[3 + k]));
    if (windingAt(tree, p) !== 0 && windingAt(matter, p) !== 0) points.push(p);
  }
  return points;
}

/** How many of the other bodies are around a body. */
function depthOf(surface, own, others) {
  const p = Array.from(placeOf(surface, surface.triangles[3 * own[0]]));
  return others.filter((tree) => windingAt(tree, p) !== 0).length;
}

/** Whether nothing is wrong: closed, manifold, no crossings, nothing without an area, bodies facing
 * out and cavities facing in. @param {any} figures of a file */
export function isSound(figures) {
  const { surface, boundaryEdges, nonManifoldEdges, crossings, crossingsAcross } = figures;
  if (boundaryEdges + nonManifoldEdges + crossings + crossingsAcross > 0) return false;
  if (figures.triangles === 0 || degenerateOf(surface).length > 0) return false;
  const pieces = closedPieces(surface);
  if (pieces.reduce((sum, own) => sum + own.length, 0) < surface.triangles.length / 3) return false;
  const trees = pieces.map((own) => treeOf(surface, own));
  return pieces.every((own, i) => {
    const others = trees.filter((_, k) => k !== i);
    const isBody = depthOf(surface, own, others) % 2 === 0;
    return volumeOf(surface, own) > 0 === isBody;
  });
}
