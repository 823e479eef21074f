// SPDX-License-Identifier: MIT
// All figures of a written file, by its bytes alone. A mesh that several nodes show counts once, in
// its own space, its angles where it shows most, as reports count it; crossings are also counted in
// the world, across all parts.
import { angleFigures, borderOf, crossingsOf, diagonalOf, edgesOf, piecesOf, surfaceOf }
  from './surface.js';

/** The area of parts where they are shown. @param {any[]} parts */
function areaOf(parts) {
  const { positions: p, triangles } = surfaceOf(parts);
  let sum = 0;
  for (let i = 0; i < triangles.length; i += 3) {
    const [a, b, c] = [...triangles.subarray(i, i + 3)].map((v) => 3 * v);
    const [u, v] = [b, c].map((end) => [0, 1, 2].map((k) => p[end + k] - p[a + k]));
    sum += Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
      u[0] * v[1] - u[1] * v[0]) / 2;
  }
  return sum;
}

/** Of several places those parts that show most. @param {any[][]} places */
function largest(places) {
  if (places.length === 1) return places[0];
  const areas = places.map(areaOf);
  return places[areas.findIndex((area) => area * (1 + 1e-9) >= Math.max(...areas))];
}

/** The parts of each mesh, joined, where they show most; of other formats the only part.
 * @param {any[]} parts @returns {any[][]} */
function meshesOf(parts) {
  const meshes = new Map();
  for (const part of parts) {
    const key = part.mesh ?? 0;
    const nodes = meshes.get(key) ?? new Map();
    nodes.set(part.node ?? 0, [...nodes.get(part.node ?? 0) ?? [], part]);
    meshes.set(key, nodes);
  }
  return [...meshes.values()].map((nodes) => largest([...nodes.values()]));
}

/** A surface in its own space, whose numbers are the written ones. */
const ownSurface = (parts) => surfaceOf(parts.map((part) =>
  ({ ...part, positions: part.local ?? part.positions })));

/** @param {any[]} parts of one mesh */
function figuresOfMesh(parts) {
  const own = ownSurface(parts);
  const edges = edgesOf(own);
  const { open, nonManifold } = borderOf(own, edges);
  return { vertices: own.positions.length / 3, triangles: own.triangles.length / 3,
    quads: own.quads, components: piecesOf(own, edges).length, boundaryEdges: open.length,
    nonManifoldEdges: nonManifold, crossings: crossingsOf(own).size,
    angles: angleFigures(surfaceOf(parts)) };
}

const counts = ['vertices', 'triangles', 'quads', 'components', 'boundaryEdges',
  'nonManifoldEdges', 'crossings'];

function angles(meshes, triangles) {
  const all = meshes.filter((mesh) => mesh.triangles > 0);
  if (all.length === 0) return { minAngle: { worst: 0, mean: 0 }, maxAngle: 0 };
  const mean = all.reduce((sum, mesh) => sum + mesh.angles.mean * mesh.triangles, 0) / triangles;
  return {
    minAngle: { worst: Math.min(...all.map((mesh) => mesh.angles.least)), mean },
    maxAngle: Math.max(...all.map((mesh) => mesh.angles.largest)),
  };
}

/** Triangles that meet those of other meshes or nodes. The world's coordinates are rounded, so that
 * borders that were equal are so again: to the precision of coordinates that were moved.
 * @param {any[]} parts */
function crossingsAcross(parts) {
  const groupOf = ({ mesh = 0, node = 0 }) => `${node} ${mesh}`;
  if (new Set(parts.map(groupOf)).size < 2) return 0;
  const step = 2 ** (Math.ceil(Math.log2(diagonalOf(surfaceOf(parts)) || 1)) - 40);
  const isMoved = parts.some((part) => part.isMoved);
  const rounded = parts.map((part) => ({ ...part, positions: isMoved
    ? part.positions.map((x) => Math.round(x / step) * step) : part.positions }));
  const groups = parts.flatMap((part) =>
    Array.from({ length: part.triangles.length / 3 }, () => groupOf(part)));
  return crossingsOf(surfaceOf(rounded), groups).size;
}

/**
 * The figures of parts that were read: `vertices` … under the report's names, `crossings`
 * (triangles that meet others of their mesh), `crossingsAcross` (of other meshes and nodes), and
 * the number of `polygons`, whose angles depend on how they are cut, and the `surface` of all parts
 * in the world. OBJ also has the `materials` that its faces name.
 * `holds`: the attributes by glTF's names, `materials` (their names), `looks` (what those are).
 * @param {{ parts: any[], materials?: Set<string>, holds?: Set<string> }} file
 */
export function figuresOf({ parts, materials, holds = new Set() }) {
  const meshes = meshesOf(parts).map(figuresOfMesh);
  const sums = Object.fromEntries(counts.map((name) =>
    [name, meshes.reduce((sum, mesh) => sum + mesh[name], 0)]));
  const surface = surfaceOf(parts);
  const polygons = parts.reduce((sum, part) => sum + (part.polygons ?? 0), 0);
  const shown = new Set(parts.map(({ node }) => node)).size;
  return { ...sums, ...angles(meshes, sums.triangles), polygons,
    crossingsAcross: crossingsAcross(parts), shown, surface, materials, holds };
}
