// SPDX-License-Identifier: MIT
// Where an open surface faces: a mask is looked at from outside.
import { Vector3 } from 'three';

/** A closed surface has no net area at all; below this share of its area one counts as closed. */
const leastShare = 0.2;

/** @param {import('three').Mesh} mesh @param {(normal: Vector3) => void} visit */
function forEachAreaNormal({ geometry, matrixWorld }, visit) {
  const position = geometry.getAttribute('position');
  const corners = geometry.index?.array;
  const points = [new Vector3(), new Vector3(), new Vector3()];
  for (let i = 0; i + 2 < (corners?.length ?? position.count); i += 3) {
    points.forEach((point, k) => {
      const index = corners ? corners[i + k] : i + k;
      point.fromBufferAttribute(position, index).applyMatrix4(matrixWorld);
    });
    visit(points[1].sub(points[0]).cross(points[2].sub(points[0])));
  }
}

/** The direction in which these surfaces together are open, null if they are closed.
 * @param {import('three').Mesh[]} meshes */
export function openSide(meshes) {
  const sum = new Vector3();
  let area = 0;
  for (const mesh of meshes) {
    forEachAreaNormal(mesh, (normal) => {
      sum.add(normal);
      area += normal.length();
    });
  }
  return sum.length() > leastShare * area ? sum.normalize() : null;
}
