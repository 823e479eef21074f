// SPDX-License-Identifier: MIT
// Compressed glTF files, made from other glTF files or from a mesh.
import { MeshoptEncoder } from 'meshoptimizer/encoder';
import draco3d from 'draco3dgltf';

import { packGlb } from '../../bindings/package/codecs/gltf_container.js';
import { GltfMaker, openGltf } from './gltf.js';

const largest = (numbers) => numbers.reduce((a, b) => Math.max(a, b), 0);

/** A GLB with each buffer view compressed; buffer views without a stride are indices. */
export async function meshoptCompressed(glb) {
  await MeshoptEncoder.ready;
  const { tree, data } = openGltf(glb);
  const result = new GltfMaker();
  const extensions = ['EXT_meshopt_compression'];
  result.tree = { ...tree, extensionsUsed: [...tree.extensionsUsed ?? [], ...extensions],
    extensionsRequired: [...tree.extensionsRequired ?? [], ...extensions] };
  const plain = tree.bufferViews.map(({ byteOffset, byteLength }) =>
    data.slice(byteOffset, byteOffset + byteLength));
  const extents = plain.map((bytes, i) => {
    const byteStride = tree.bufferViews[i].byteStride ?? 2;
    const mode = tree.bufferViews[i].byteStride ? 'ATTRIBUTES' : 'TRIANGLES';
    const count = bytes.length / byteStride;
    result.views.push(MeshoptEncoder.encodeGltfBuffer(bytes, count, byteStride, mode));
    return { count, byteStride, mode };
  });
  const compressed = result.data();
  tree.bufferViews.forEach((view, i) => {
    const { byteOffset, byteLength } = view;
    view.extensions = { EXT_meshopt_compression:
      { buffer: 0, byteOffset, byteLength, ...extents[i] } };
    Object.assign(view, { buffer: 1, byteOffset: 0, byteLength: plain[i].length });
  });
  result.tree.buffers.push({ byteLength: largest(plain.map(({ length }) => length)),
    extensions: { EXT_meshopt_compression: { fallback: true } } });
  return { name: 'made.glb', bytes: packGlb(result.tree, compressed) };
}

/** Draco's bytes of a mesh with texture coordinates, and Draco's ids of the attributes. */
async function dracoEncoded({ positions, indices, texcoords }) {
  const draco = await draco3d.createEncoderModule({});
  const encoder = new draco.Encoder();
  const builder = new draco.MeshBuilder();
  const mesh = new draco.Mesh();
  const count = positions.length / 3;
  encoder.SetAttributeQuantization(draco.POSITION, 16);
  encoder.SetAttributeQuantization(draco.TEX_COORD, 16);
  builder.AddFacesToMesh(mesh, indices.length / 3, indices);
  const ids = {
    POSITION: builder.AddFloatAttributeToMesh(mesh, draco.POSITION, count, 3, positions),
    TEXCOORD_0: builder.AddFloatAttributeToMesh(mesh, draco.TEX_COORD, count, 2, texcoords),
  };
  const target = new draco.DracoInt8Array();
  const length = encoder.EncodeMeshToDracoBuffer(mesh, target);
  const bytes = Int8Array.from({ length }, (_, i) => target.GetValue(i));
  [target, mesh, builder, encoder].forEach((object) => draco.destroy(object));
  return { bytes, ids };
}

/** A GLB whose one primitive is compressed. */
export async function dracoCompressed(mesh) {
  const { bytes, ids } = await dracoEncoded(mesh);
  const count = mesh.positions.length / 3;
  const maker = new GltfMaker();
  const bufferView = maker.addView(bytes);
  const accessor = { componentType: 5126, count };
  maker.show([{
    attributes: {
      POSITION: maker.describe({ ...accessor, type: 'VEC3' }, mesh.positions),
      TEXCOORD_0: maker.describe({ ...accessor, type: 'VEC2' }),
    },
    indices: maker.describe({ componentType: 5123, count: mesh.indices.length, type: 'SCALAR' }),
    extensions: { KHR_draco_mesh_compression: { bufferView, attributes: ids } },
  }]);
  Object.assign(maker.tree, { extensionsUsed: ['KHR_draco_mesh_compression'],
    extensionsRequired: ['KHR_draco_mesh_compression'] });
  return maker.glb();
}
