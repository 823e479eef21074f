// SPDX-License-Identifier: MIT
// A surface that answers how far a point is from it, and where a ray hits it. three-mesh-bvh does
// the search.
import { Box3, BufferAttribute, BufferGeometry, DoubleSide, Ray, Vector3 } from 'three';
import { MeshBVH } from 'three-mesh-bvh';

/** @typedef {import('../triangles/soup.js').Soup} Soup */
/** @typedef {[number, number, number]} Point */
/** distance: in model units, from `point` on one surface to `nearest` on the other.
 * @typedef {{ distance: number, point: Point, nearest: Point }} Place */

export class Surface {
  /** @type {MeshBVH | undefined} */
  #made;

  /** @param {Soup} soup */
  constructor(soup) {
    this.soup = soup;
  }

  /** Made when it is first needed: of millions of triangles it takes seconds. */
  get #tree() {
    if (this.#made) return this.#made;
    const geometry = new BufferGeometry()
      .setAttribute('position', new BufferAttribute(this.soup.positions, 3))
      .setIndex(new BufferAttribute(this.soup.indices, 1));
    this.#made = new MeshBVH(geometry, { indirect: true });
    return this.#made;
  }

  /** @param {Vector3} point */
  distanceTo(point) {
    return this.#tree.closestPointToPoint(point)?.distance ?? 0;
  }

  /** @param {Vector3} point @returns {Point} */
  nearest(point) {
    return (this.#tree.closestPointToPoint(point)?.point ?? point).toArray();
  }

  /** @param {Point} origin @param {Point} direction */
  hit(origin, direction) {
    const ray = new Ray(new Vector3(...origin), new Vector3(...direction).normalize());
    return this.#tree.raycastFirst(ray, DoubleSide);
  }

  /** The triangle's unit normal. @param {number} triangle */
  #normal(triangle) {
    const { positions, indices } = this.soup;
    const [a, b, c] = [0, 1, 2].map((k) =>
      new Vector3().fromArray(positions, 3 * indices[3 * triangle + k]));
    return b.sub(a).cross(c.sub(a)).normalize();
  }

  /** A direction from which a place of the surface is visible: the wished direction if it is clear,
   * else a clear one near the normal. If none is clear: the wished direction.
   * @param {Point} point @param {Point} wished @returns {Point} of unit length */
  viewOf(point, wished) {
    const place = new Vector3(...point);
    const normal = this.#normal(this.#tree.closestPointToPoint(place)?.faceIndex ?? 0);
    const leans = [[0, 0, 0], [1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]];
    const directions = [new Vector3(...wished).normalize(),
      ...leans.map((lean) => normal.clone().add(new Vector3(...lean)).normalize())];
    const isClear = (/** @type {Vector3} */ direction) => {
      const start = place.clone().addScaledVector(direction, 1e-3 * this.#size);
      return direction.dot(normal) > 0.2 && !this.hit(start.toArray(), direction.toArray());
    };
    return (directions.find(isClear) ?? directions[0]).toArray();
  }

  /** The length of the bounding box's diagonal. */
  get #size() {
    return this.#tree.getBoundingBox(new Box3()).getSize(new Vector3()).length();
  }

  /** Visits the sample points of distances: all vertices, then the centroids of all triangles.
   * @param {(point: Vector3, vertex: number) => void} visit vertex: -1 for a centroid
   * @param {number} step of so many places one is visited */
  forEachPlace(visit, step) {
    const { positions, indices } = this.soup;
    const point = new Vector3(), corner = new Vector3();
    for (let v = 0; v < positions.length / 3; v += step) {
      visit(point.fromArray(positions, 3 * v), v);
    }
    for (let i = 0; i < indices.length; i += 3 * step) {
      point.set(0, 0, 0);
      for (let k = 0; k < 3; ++k) point.add(corner.fromArray(positions, 3 * indices[i + k]));
      visit(point.multiplyScalar(1 / 3), -1);
    }
  }
}

const binCount = 30;
/** Of a scan's places so many are measured: all of ten million would take minutes. */
const mostPlaces = 500_000;

/** The place of one surface that is farthest from another, and the distances of its vertices.
 * @param {Surface} from @param {Surface} to @param {number} [step] of so many places one counts
 * @returns {{ values: Float32Array, all: Float32Array, largest: Place }} all: of the vertices, then
 *   of the triangles' centroids */
function distancesFrom(from, to, step = 1) {
  const values = new Float32Array(from.soup.positions.length / 3);
  /** @type {number[]} */
  const all = [];
  let farthest = new Vector3(), distance = -1;
  from.forEachPlace((point, vertex) => {
    const own = to.distanceTo(point);
    all.push(own);
    if (vertex >= 0) values[vertex] = own;
    if (own <= distance) return;
    distance = own;
    farthest = point.clone();
  }, step);
  const largest = { distance, point: farthest.toArray(), nearest: to.nearest(farthest) };
  return { values, all: Float32Array.from(all), largest };
}

/**
 * values: for each vertex of the result; largest: as the report has it, in model units; place: of
 * the sample point that is farthest away; bins: shares of all sample points, from distance 0 to the
 * largest; edges: lengths of the result's.
 * @typedef {{ values: Float32Array, largest: number, place: Place, bins: number[],
 *   edges: { least: number, mean: number, most: number } }} Distances
 */

/** The lengths of a surface's edges. @param {Surface} surface */
function edgesOf({ soup: { positions, indices } }) {
  let least = Infinity, most = 0, sum = 0;
  const from = new Vector3(), to = new Vector3();
  for (let i = 0; i < indices.length; ++i) {
    const next = i % 3 === 2 ? i - 2 : i + 1;
    const length = from.fromArray(positions, 3 * indices[i])
      .distanceTo(to.fromArray(positions, 3 * indices[next]));
    least = Math.min(least, length);
    most = Math.max(most, length);
    sum += length;
  }
  return { least, mean: sum / indices.length, most };
}

/** Distances between two surfaces, both ways. The core measures more finely, so the largest
 * distance is the core's, where it has measured. A repair leaves out what is not seen, and says so:
 * of that the distances are not. @param {Surface} result @param {Surface} original
 * @param {{ known: number | null, isRepair: boolean }} how known: the largest
 * @param {number} [most] places of the original that are measured
 * @returns {Distances} */
export function measureDistances(result, original, { known, isRepair }, most = mostPlaces) {
  const there = distancesFrom(result, original);
  const { positions, indices } = original.soup;
  const step = Math.ceil((positions.length + indices.length) / 3 / most);
  const back = isRepair ? there : distancesFrom(original, result, step);
  const { point, nearest, distance } = back.largest;
  // The place must be on the result, because the colours are there.
  const place = distance > there.largest.distance
    ? { distance, point: nearest, nearest: point } : there.largest;
  const largest = known ?? place.distance;
  const bins = new Array(binCount).fill(0);
  const lists = isRepair ? [there.all] : [there.all, back.all];
  const places = lists.reduce((sum, list) => sum + list.length, 0);
  for (const list of lists) {
    for (const value of list) {
      const bin = Math.min(binCount - 1, Math.floor(binCount * value / (largest || 1)));
      bins[bin] += 1 / places;
    }
  }
  return { values: there.values, largest, place, bins, edges: edgesOf(result) };
}
