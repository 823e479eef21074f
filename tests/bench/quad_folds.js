// SPDX-License-Identifier: MIT
// Quads that are turned away from the surface: no triangle of the original near them faces the way
// that they do.
import { BufferAttribute, BufferGeometry, Sphere, Vector3 } from 'three';
import { MeshBVH } from 'three-mesh-bvh';

/** How far beyond the nearest triangle others count, in sides of the quad. */
const reach = 0.3;
/** Cosines of what stands upright on what is near, which is bent, and of what faces away. */
const [upright, away] = [0.1, 0.7];

/** A tree of a mesh's triangles. */
export function treeOf({ positions, indices }) {
  const geometry = new BufferGeometry().setIndex(Array.from(indices));
  geometry.setAttribute('position', new BufferAttribute(Float64Array.from(positions), 3));
  return new MeshBVH(geometry, { indirect: true });
}

/** The corners of quad q. @returns {Vector3[]} */
export const cornersOfQuad = ({ positions, quads }, q) => [0, 1, 2, 3].map((k) =>
  new Vector3().fromArray(positions, 3 * quads[4 * q + k]));

/** As long as the quad is large. @param {Vector3[]} corners */
export const areaVector = ([a, b, c, d]) =>
  c.clone().sub(a).cross(d.clone().sub(b)).multiplyScalar(0.5);

function facesAway(tree, corners) {
  const middle = corners.reduce((sum, p) => sum.add(p), new Vector3()).multiplyScalar(0.25);
  const normal = areaVector(corners);
  const side = Math.sqrt(normal.length());
  if (side === 0) return true;
  const hit = tree.closestPointToPoint(middle);
  const ball = new Sphere(middle, hit.distance + reach * side);
  const near = new Vector3();
  const way = new Vector3();
  let [most, least] = [-1, 1];
  tree.shapecast({
    intersectsBounds: (/** @type {any} */ box) => ball.intersectsBox(box),
    intersectsTriangle: (/** @type {any} */ triangle) => {
      if (triangle.closestPointToPoint(middle, near).distanceTo(middle) > ball.radius) return false;
      const cosine = triangle.getNormal(way).dot(normal) / normal.length();
      [most, least] = [Math.max(most, cosine), Math.min(least, cosine)];
      return false;
    },
  });
  return most < upright && least < -away;
}

/** @param {any} original of triangles @param {any} mesh of quads */
export function countTurnedAway(original, mesh) {
  const tree = treeOf(original);
  let count = 0;
  for (let q = 0; q < mesh.quads.length / 4; q += 1) {
    count += facesAway(tree, cornersOfQuad(mesh, q)) ? 1 : 0;
  }
  return count;
}
