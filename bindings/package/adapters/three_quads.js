// SPDX-License-Identifier: MIT
// Quads in geometries of three.js, which knows triangles only: two triangles in a row of the index,
// from the same first corner, are one.

import { BufferGeometry } from 'three';

import { RemeshError } from '../base/errors.js';

/**
 * The quads of a geometry that is made of them, as `remeshGeometry` makes it with `quads: true` and
 * as `GLTFLoader` reads it from a file with FB_ngon_encoding.
 *
 * @example
 * const { geometry } = await remeshGeometry(mesh.geometry, { quads: true, vertices: 5000 });
 * quadsOf(geometry).length / 4;
 *
 * @param {BufferGeometry} geometry Quads alone.
 * @returns {Uint32Array} Four vertices for each, counterclockwise.
 */
export function quadsOf({ index }) {
  const count = (index?.count ?? 0) / 6;
  if (!index || !Number.isInteger(count)) {
    throw new RemeshError('INVALID_MESH', 'The geometry has no index of quads.');
  }
  const quads = new Uint32Array(4 * count);
  for (let q = 0; q < count; q += 1) {
    const [a, b, c, again, same, d] = [0, 1, 2, 3, 4, 5].map((k) => index.getX(6 * q + k));
    if (a !== again || c !== same) {
      throw new RemeshError('INVALID_MESH',
        `The triangles ${2 * q} and ${2 * q + 1} of the geometry are no quad.`);
    }
    quads.set([a, b, c, d], 4 * q);
  }
  return quads;
}

/** The first vertex where each vertex is: those along seams are in one place.
 * @param {BufferGeometry['attributes']['position']} position */
function firstAtPlaces(position) {
  /** @type {Map<string, number>} */
  const known = new Map();
  return Uint32Array.from({ length: position.count }, (_, vertex) => {
    const place = `${position.getX(vertex)} ${position.getY(vertex)} ${position.getZ(vertex)}`;
    const first = known.get(place) ?? vertex;
    known.set(place, first);
    return first;
  });
}

/**
 * The edges of quads, each once, without the diagonals that a wireframe of their triangles has, for
 * `LineSegments`. The positions are the geometry's own, so dispose of both.
 *
 * @example
 * scene.add(new LineSegments(quadEdges(geometry), new LineBasicMaterial({ color: 0x0b1f22 })));
 *
 * @param {BufferGeometry} geometry Quads alone.
 * @returns {BufferGeometry} On the same positions and morph targets, two vertices an edge.
 */
export function quadEdges(geometry) {
  const { position } = geometry.attributes;
  const quads = quadsOf(geometry);
  const places = firstAtPlaces(position);
  /** @type {Set<number>} */
  const edges = new Set();
  for (let corner = 0; corner < quads.length; corner += 1) {
    const next = corner % 4 === 3 ? corner - 3 : corner + 1;
    const [a, b] = [places[quads[corner]], places[quads[next]]];
    edges.add(Math.min(a, b) * position.count + Math.max(a, b));
  }
  const index = [...edges].flatMap((edge) =>
    [Math.floor(edge / position.count), edge % position.count]);
  const lines = new BufferGeometry().setAttribute('position', position).setIndex(index);
  if (geometry.morphAttributes.position) {
    lines.morphAttributes.position = geometry.morphAttributes.position;
    lines.morphTargetsRelative = geometry.morphTargetsRelative;
  }
  return lines;
}
