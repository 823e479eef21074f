// SPDX-License-Identifier: MIT
// The nearest point of a mesh by brute force: slow, but too simple to be wrong.
import { Triangle, Vector3 } from 'three';

/** The vertex as a vector. */
export function vertexOf(positions, v) {
  return new Vector3(positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]);
}

export class NearestPoints {
  /** @param {{ positions: ArrayLike<number>, indices: ArrayLike<number> }} mesh */
  constructor({ positions, indices }) {
    this.indices = indices;
    this.triangles = Array.from({ length: indices.length / 3 }, (_, t) =>
      new Triangle(...[0, 1, 2].map((k) => vertexOf(positions, indices[3 * t + k]))));
  }

  /** All triangles at most `slack` farther than the nearest, with the barycentric weights of their
   * nearest points. */
  find(point, slack = 0) {
    const distances = this.triangles.map((triangle) =>
      triangle.closestPointToPoint(point, new Vector3()).distanceTo(point));
    const distance = distances.reduce((a, b) => Math.min(a, b));
    const places = distances.flatMap((d, t) => {
      if (d > distance + slack) return [];
      const near = this.triangles[t].closestPointToPoint(point, new Vector3());
      const weights = this.triangles[t].getBarycoord(near, new Vector3()).toArray();
      return [{ corners: this.indices.slice(3 * t, 3 * t + 3), weights }];
    });
    return { distance, places };
  }

  distance(point) {
    const near = new Vector3();
    return this.triangles.reduce((least, triangle) =>
      Math.min(least, triangle.closestPointToPoint(point, near).distanceToSquared(point)), Infinity)
      ** 0.5;
  }
}
