// SPDX-License-Identifier: MIT
// Surfaces as PLY and STL, written by three.js.
import { BufferAttribute, BufferGeometry, Mesh } from 'three';
import { PLYExporter } from 'three/addons/exporters/PLYExporter.js';
import { STLExporter } from 'three/addons/exporters/STLExporter.js';

const bytesOf = (written) => (typeof written === 'string' ? new TextEncoder().encode(written)
  : new Uint8Array(written.buffer ?? written, written.byteOffset ?? 0, written.byteLength));

/** Colours and texture coordinates computed from the position. */
function meshOf({ positions, triangles }) {
  const rows = (width, row) => new BufferAttribute(
    Float32Array.from(positions.flatMap(row)), width);
  const geometry = new BufferGeometry().setIndex(triangles.flat())
    .setAttribute('position', rows(3, (p) => p))
    .setAttribute('color', rows(3, (_, i) => [(i % 7) / 7, 0.5, 1]))
    .setAttribute('uv', rows(2, ([x, y]) => [x, y]));
  geometry.computeVertexNormals();
  return new Mesh(geometry);
}

const ply = (shape, options) =>
  ({ name: 'made.ply', bytes: bytesOf(new PLYExporter().parse(meshOf(shape), null, options)) });
const stl = (shape, options) =>
  ({ name: 'made.stl', bytes: bytesOf(new STLExporter().parse(meshOf(shape), options)) });

/** For each kind: writes a surface as a file. */
export const scans = {
  ply: (shape) => ply(shape, { binary: true, littleEndian: true }),
  'ply in text': (shape) => ply(shape, {}),
  'ply of the other order': (shape) => ply(shape, { binary: true }),
  stl: (shape) => stl(shape, { binary: true }),
  'stl in text': (shape) => stl(shape, {}),
};
