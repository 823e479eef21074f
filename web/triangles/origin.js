// SPDX-License-Identifier: MIT
// The survey computes, and lines are drawn, in single precision. Far from the origin it is too
// coarse for a shape: at 5 million its steps are half a unit. So the stage has an origin of its
// own.
import { Vector3 } from 'three';

/** Up to so many diagonals away, single precision's rounding does not show. */
const farDiagonals = 4;

/** The stage's origin in a model's world: near the model if that is far from zero, else zero.
 * @param {import('three').Box3} bounds */
export function originNear(bounds) {
  const step = 2 * farDiagonals * bounds.getSize(new Vector3()).length() || 1;
  return bounds.getCenter(new Vector3()).divideScalar(step).round().multiplyScalar(step);
}
