// SPDX-License-Identifier: MIT
// Makes glTF files for tests, reads glTF files, and judges them by the Khronos validator.
import validator from 'gltf-validator';

import { openContainer, packGlb } from '../../bindings/package/codecs/gltf_container.js';

const componentTypes = new Map([[Int8Array, 5120], [Uint8Array, 5121], [Int16Array, 5122],
  [Uint16Array, 5123], [Uint32Array, 5125], [Float32Array, 5126]]);
const components = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };

const asBytes = (array) => new Uint8Array(array.buffer, array.byteOffset, array.byteLength);

export class GltfMaker {
  tree = { asset: { version: '2.0' }, buffers: [], bufferViews: [], accessors: [] };
  views = [];

  /** Returns the buffer view's number. */
  addView(array, properties = {}) {
    this.views.push(asBytes(array));
    return this.tree.bufferViews.push(properties) - 1;
  }

  /** Adds an accessor whose rows are padded to multiples of four bytes. */
  add(array, type, { normalized } = {}) {
    const width = components[type];
    const count = array.length / width;
    const stride = Math.ceil((width * array.BYTES_PER_ELEMENT) / 4) * 4;
    const padded = new array.constructor((count * stride) / array.BYTES_PER_ELEMENT);
    for (let i = 0; i < count; i += 1) {
      padded.set(array.subarray(i * width, (i + 1) * width),
        (i * stride) / array.BYTES_PER_ELEMENT);
    }
    return this.describe({
      bufferView: this.addView(padded, { byteStride: stride }),
      componentType: componentTypes.get(array.constructor),
      count,
      type,
      ...(normalized ? { normalized } : {}),
    }, array);
  }

  /** Adds an accessor of unpadded numbers, as for indices and times. */
  addIndices(array) {
    return this.describe({
      bufferView: this.addView(array),
      componentType: componentTypes.get(array.constructor),
      count: array.length,
      type: 'SCALAR',
    });
  }

  /** Adds an accessor, with bounds if its values are given and have three components. */
  describe(accessor, values) {
    const width = components[accessor.type];
    if (values && width === 3) {
      const column = (k) => values.filter((_, i) => i % 3 === k);
      accessor.min = [0, 1, 2].map((k) => column(k).reduce((a, b) => Math.min(a, b)));
      accessor.max = [0, 1, 2].map((k) => column(k).reduce((a, b) => Math.max(a, b)));
    }
    return this.tree.accessors.push(accessor) - 1;
  }

  /** Adds a scene that shows a mesh of these primitives once. */
  show(primitives) {
    this.tree.meshes = [{ primitives }];
    this.tree.nodes = [{ mesh: 0 }];
    this.tree.scenes = [{ nodes: [0] }];
    this.tree.scene = 0;
    return this;
  }

  /** All views one after another; writes their offsets into the tree. */
  data() {
    const length = this.views.reduce((sum, { length: l }) => sum + Math.ceil(l / 4) * 4, 0);
    const data = new Uint8Array(length);
    let at = 0;
    this.views.forEach((bytes, i) => {
      data.set(bytes, at);
      Object.assign(this.tree.bufferViews[i],
        { buffer: 0, byteOffset: at, byteLength: bytes.length });
      at += Math.ceil(bytes.length / 4) * 4;
    });
    this.tree.buffers = [{ byteLength: length }];
    return data;
  }

  glb() {
    const data = this.data();
    return { name: 'made.glb', bytes: packGlb(this.tree, data) };
  }

  /** A .gltf whose buffer is a separate file. */
  gltf(uri = 'made.bin') {
    const data = this.data();
    const tree = { ...this.tree, buffers: [{ ...this.tree.buffers[0], uri }] };
    const bytes = new TextEncoder().encode(JSON.stringify(tree));
    return { name: 'made.gltf', bytes, resources: { 'made.bin': data } };
  }

  embedded() {
    const { name, bytes } = this.gltf(
      `data:application/octet-stream;base64,${Buffer.from(this.data()).toString('base64')}`);
    return { name, bytes };
  }
}

/** All messages of the validator on a file, with the files beside it. */
export async function issuesOf({ bytes, files = [] }) {
  const { issues } = await validator.validateBytes(new Uint8Array(bytes), {
    maxIssues: 0,
    externalResourceFunction: async (uri) => {
      const file = files.find(({ name }) => name === decodeURIComponent(uri));
      if (!file) throw new Error(`${uri} is missing`);
      return file.bytes;
    },
  });
  return issues.messages;
}

/** The validator's errors, in words. */
export async function validate(file) {
  return (await issuesOf(file)).filter(({ severity }) => severity === 0)
    .map(({ code, message, pointer }) => `${pointer}: ${code}: ${message}`);
}

/** The tree, and the buffer: the binary chunk or the first of the other files. */
export function openGltf({ bytes, files = [] }) {
  const { text, chunk } = openContainer(bytes);
  const tree = JSON.parse(text);
  const { uri } = tree.buffers?.[0] ?? {};
  if (uri?.startsWith('data:')) {
    return { tree, data: new Uint8Array(Buffer.from(uri.slice(uri.indexOf(',') + 1), 'base64')) };
  }
  return { tree, data: chunk ?? files[1]?.bytes };
}

const readers = {
  5120: ['getInt8', 1, 127],
  5121: ['getUint8', 1, 255],
  5122: ['getInt16', 2, 32767],
  5123: ['getUint16', 2, 65535],
  5125: ['getUint32', 4, 1],
  5126: ['getFloat32', 4, 1],
};

/** The values of an accessor, one array per element; normalized integers become fractions. */
export function valuesOf({ tree, data }, accessorNumber) {
  const accessor = tree.accessors[accessorNumber];
  const { byteOffset = 0, byteStride } = tree.bufferViews[accessor.bufferView];
  const [read, size, largest] = readers[accessor.componentType];
  const width = components[accessor.type];
  const view = new DataView(data.buffer, data.byteOffset, data.byteLength);
  const at = (row, k) => byteOffset + (accessor.byteOffset ?? 0)
    + row * (byteStride ?? width * size) + k * size;
  return Array.from({ length: accessor.count }, (_, row) => Array.from({ length: width }, (__, k) =>
    view[read](at(row, k), true) / (accessor.normalized ? largest : 1)));
}
