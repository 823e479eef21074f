// SPDX-License-Identifier: MIT
// Far from the origin single precision, in which the survey counts and lines are drawn, has no
// digits left for a shape: at 5 million its steps are half a unit. So the stage has an origin of
// its own.
import { Vector3 } from 'three';

/** Up to so many diagonals away, what single precision loses does not show. */
const farDiagonals = 4;

/** The stage's origin in a model's world: near the model, and zero unless that is far away.
 * @param {import('three').Box3} bounds */
export function originNear(bounds) {
  const step = 2 * farDiagonals * bounds.getSize(new Vector3()).length() || 1;
  return bounds.getCenter(new Vector3()).divideScalar(step).round().multiplyScalar(step);
}
