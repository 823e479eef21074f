// SPDX-License-Identifier: MIT
// A glTF file simplified by meshoptimizer, for comparison with baked textures.
import { NodeIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS } from '@gltf-transform/extensions';
import { dedup, weld } from '@gltf-transform/functions';
import { MeshoptSimplifier } from 'meshoptimizer';

// As in the simplifier's own examples.
const weights = { NORMAL: 0.5, TEXCOORD_0: 1, COLOR_0: 1 };

/** The attributes that the simplifier uses besides positions, vertex by vertex. */
function attributesOf(primitive, count) {
  const columns = Object.entries(weights).flatMap(([semantic, weight]) => {
    const accessor = primitive.getAttribute(semantic);
    return Array.from({ length: accessor?.getElementSize() ?? 0 }, (_, k) =>
      ({ weight, at: (i) => accessor.getElement(i, [])[k] }));
  });
  const rows = Array.from({ length: count }, (_, i) => columns.map(({ at }) => at(i)));
  return { values: Float32Array.from(rows.flat()), weights: columns.map(({ weight }) => weight) };
}

function simplifyPrimitive(primitive, ratio) {
  const places = primitive.getAttribute('POSITION');
  const count = places.getCount();
  const positions = Float32Array.from(
    Array.from({ length: count }, (_, i) => places.getElement(i, [])).flat());
  const indices = Uint32Array.from(primitive.getIndices().getArray());
  const target = 3 * Math.round((Math.min(ratio, 1) * indices.length) / 3);
  const { values, weights: of } = attributesOf(primitive, count);
  const [result] = of.length > 0
    ? MeshoptSimplifier.simplifyWithAttributes(indices, positions, 3, values, of.length, of, null,
      target, 1)
    : MeshoptSimplifier.simplify(indices, positions, 3, target, 1);
  primitive.getIndices().setArray(result);
}

/** The file with about `triangles` triangles, and with its textures unchanged. */
export async function simplified(bytes, triangles) {
  const io = new NodeIO().registerExtensions(ALL_EXTENSIONS);
  const document = await io.readBinary(bytes);
  await document.transform(weld(), dedup());
  await MeshoptSimplifier.ready;
  const primitives = document.getRoot().listMeshes().flatMap((mesh) => mesh.listPrimitives());
  const before = primitives.reduce((sum, p) => sum + p.getIndices().getCount() / 3, 0);
  for (const primitive of primitives) simplifyPrimitive(primitive, triangles / before);
  return io.writeBinary(document);
}
