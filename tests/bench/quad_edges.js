// SPDX-License-Identifier: MIT
// How much of the sharp edges of an original is sides of quads, and how well rows of quads on flat
// sides run along straight edges.
import { Vector3 } from 'three';

import { areaVector, cornersOfQuad } from './quad_folds.js';

const degree = Math.PI / 180;
/** Of the original; between quads an edge may be blunter, for they cut off what is round. */
const [sharp, sharpOfQuads] = [Math.cos(40 * degree), Math.cos(20 * degree)];
/** Where edges of more than this angle are so many times as long as the sharp ones together, all of
 * the surface bends, and its sharp edges are none of a part. */
const [bent, mostBent] = [Math.cos(20 * degree), 1.35];
/** Samples of an edge are so many sides apart, and found within so many: four sides around a hole
 * are a fifth of a side away from it. */
const [apart, near] = [0.1, 0.25];
/** A side may cut off an arc of a quarter turn. */
const along = Math.cos(50 * degree);
/** Groups of sharp edges that are smaller, in sides, are bumps. */
const leastExtent = 3;
const straight = Math.cos(0.5 * degree);
const [leastStraight, rowsWithin] = [4, 5];

/** Triangles by numbers of places, places at one spot joined. */
function welded({ positions, indices }) {
  const numbers = new Map();
  const points = [];
  const numberOf = (v) => {
    const key = Array.from(positions.subarray(3 * v, 3 * v + 3), (x) => x + 0).join();
    if (!numbers.has(key)) {
      numbers.set(key, points.push(new Vector3().fromArray(positions, 3 * v)) - 1);
    }
    return numbers.get(key);
  };
  const corners = Array.from(indices, numberOf);
  const faces = [];
  for (let i = 0; i < corners.length; i += 3) {
    const face = corners.slice(i, i + 3);
    if (new Set(face).size === 3) faces.push(face);
  }
  return { points, faces };
}

/** Edges between two faces whose normals differ by more than the angle of this cosine. */
function sharpEdges(points, faces, normals, cosine) {
  const around = new Map();
  faces.forEach((face, f) => face.forEach((a, k) => {
    const b = face[(k + 1) % face.length];
    const key = a < b ? `${a} ${b}` : `${b} ${a}`;
    if (!around.has(key)) around.set(key, { ends: [a, b], faces: [] });
    around.get(key).faces.push(f);
  }));
  return [...around.values()].filter(({ faces: [f, g, ...more] }) => g !== undefined &&
    more.length === 0 && normals[f].dot(normals[g]) < cosine)
    .map(({ ends, faces: beside }) => ({ ends, faces: beside, from: points[ends[0]],
      to: points[ends[1]] }));
}

const lengthOf = (edges) => edges.reduce((sum, { from, to }) => sum + from.distanceTo(to), 0);

/** Edges in groups that hang together, of those groups that are large enough. */
function withoutSmall(edges, least) {
  const byVertex = new Map();
  edges.forEach((edge) => edge.ends.forEach((v) =>
    byVertex.set(v, [...byVertex.get(v) ?? [], edge])));
  const kept = [];
  const seen = new Set();
  for (const first of edges) {
    if (seen.has(first)) continue;
    const group = [first];
    seen.add(first);
    for (let i = 0; i < group.length; i += 1) {
      const more = group[i].ends.flatMap((v) => byVertex.get(v)).filter((edge) => !seen.has(edge));
      new Set(more).forEach((edge) => seen.add(edge) && group.push(edge));
    }
    const places = group.flatMap(({ from, to }) => [from, to]);
    const low = places.reduce((a, p) => a.min(p), places[0].clone());
    const high = places.reduce((a, p) => a.max(p), places[0].clone());
    if (low.distanceTo(high) >= least) kept.push(...group);
  }
  return kept;
}

function samplesOf({ from, to }, step) {
  const length = from.distanceTo(to);
  const count = Math.max(1, Math.ceil(length / step));
  const way = to.clone().sub(from).normalize();
  return Array.from({ length: count }, (_, i) =>
    ({ at: from.clone().lerp(to, (i + 0.5) / count), way, length: length / count }));
}

/** Samples by the cells of a grid. */
function gridOf(samples, size) {
  const cells = new Map();
  const cellOf = (p) => p.toArray().map((x) => Math.floor(x / size));
  for (const sample of samples) {
    const key = cellOf(sample.at).join();
    if (!cells.has(key)) cells.set(key, []);
    cells.get(key).push(sample);
  }
  const steps = [-1, 0, 1];
  return (p) => {
    const [x, y, z] = cellOf(p);
    return steps.flatMap((i) => steps.flatMap((k) => steps.flatMap((l) =>
      cells.get(`${x + i},${y + k},${z + l}`) ?? [])));
  };
}

/** Of the flat quads the percentage whose rows run within a few degrees of the nearest straight
 * edge in their plane. */
function rowsAlong(mesh, edges, side) {
  const { points, faces, normals } = edges;
  const longEnough = edges.sharp.filter(({ from, to }) =>
    from.distanceTo(to) >= leastStraight * side);
  if (longEnough.length === 0) return undefined;
  const samples = longEnough.flatMap((edge) => samplesOf(edge, side / 2).map((sample) =>
    ({ ...sample, planes: edge.faces.map((f) => ({ normal: normals[f],
      height: normals[f].dot(points[faces[f][0]]) })) })));
  let [flat, good] = [0, 0];
  for (let q = 0; q < mesh.quads.length / 4; q += 1) {
    const corners = cornersOfQuad(mesh, q);
    const normal = areaVector(corners).normalize();
    const isIn = (plane) => plane.normal.dot(normal) > straight &&
      corners.every((p) => Math.abs(plane.normal.dot(p) - plane.height) < 0.02 * side);
    let nearest;
    let least = Infinity;
    for (const sample of samples) {
      const distance = sample.at.distanceToSquared(corners[0]);
      if (distance < least && sample.planes.some(isIn)) [nearest, least] = [sample, distance];
    }
    if (!nearest) continue;
    flat += 1;
    const row = corners[1].clone().sub(corners[0]).add(corners[2]).sub(corners[3]).normalize();
    const turn = Math.acos(Math.min(1, Math.abs(row.dot(nearest.way)))) / degree;
    if (Math.min(turn, 90 - turn) <= rowsWithin) good += 1;
  }
  return flat > 0 ? (100 * good) / flat : undefined;
}

/** kept: percent of the sharp edges that are sides of quads; rows: percent of the flat quads. Of
 * surfaces without sharp edges all are kept. */
export function sharpEdgesKept(original, mesh) {
  const { points, faces } = welded(original);
  const normals = faces.map(([a, b, c]) => points[b].clone().sub(points[a])
    .cross(points[c].clone().sub(points[a])).normalize());
  const count = mesh.quads.length / 4;
  const quadNormals = Array.from({ length: count }, (_, q) => areaVector(cornersOfQuad(mesh, q)));
  const side = Math.sqrt(quadNormals.reduce((sum, n) => sum + n.length(), 0) / count);
  const edges = sharpEdges(points, faces, normals, sharp);
  const isBent = lengthOf(sharpEdges(points, faces, normals, bent)) > mostBent * lengthOf(edges);
  const wanted = isBent ? [] : withoutSmall(edges, leastExtent * side);
  if (wanted.length === 0) return { kept: 100, rows: undefined };
  const quadPoints = Array.from({ length: mesh.positions.length / 3 }, (_, v) =>
    new Vector3().fromArray(mesh.positions, 3 * v));
  const quadFaces = Array.from({ length: count }, (_, q) =>
    Array.from(mesh.quads.subarray(4 * q, 4 * q + 4)));
  const found = sharpEdges(quadPoints, quadFaces, quadNormals.map((n) => n.clone().normalize()),
    sharpOfQuads).flatMap((edge) => samplesOf(edge, side * apart));
  const around = gridOf(found, near * side);
  let [whole, kept] = [0, 0];
  for (const sample of wanted.flatMap((edge) => samplesOf(edge, side * apart))) {
    whole += sample.length;
    if (around(sample.at).some(({ at, way }) => at.distanceTo(sample.at) <= near * side &&
      Math.abs(way.dot(sample.way)) >= along)) kept += sample.length;
  }
  return { kept: (100 * kept) / whole,
    rows: rowsAlong(mesh, { points, faces, normals, sharp: wanted }, side) };
}
