// SPDX-License-Identifier: MIT
// remesher/gltf-transform: the same as remeshFile, in a document, beside other transforms.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { Document, Logger, NodeIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS, EXTMeshGPUInstancing } from '@gltf-transform/extensions';
import {
  dedup, dequantize, prune, quantize, simplify, weld,
} from '@gltf-transform/functions';
import { MeshoptSimplifier } from 'meshoptimizer';
import { RemeshError, remeshFile } from 'remesher';
import { remesh } from 'remesher/gltf-transform';

import { validate } from '../support/gltf.js';
import { distinctPositions, sheet, torus } from '../support/shapes.js';
import { skinnedTorus } from '../support/skinned_torus.js';

const io = new NodeIO().registerExtensions(ALL_EXTENSIONS);
const file = skinnedTorus();
const primitivesOf = (document) =>
  document.getRoot().listMeshes().flatMap((mesh) => mesh.listPrimitives());
const quiet = (document) => document.setLogger(new Logger(Logger.Verbosity.SILENT));
const opened = async (bytes) => quiet(await io.readBinary(bytes));
const arrayOf = (primitive, semantic) => primitive.getAttribute(semantic).getArray();

/** Places of all primitives, each once. */
function countOf(document) {
  return document.getRoot().listMeshes().reduce((sum, mesh) => sum + distinctPositions(
    mesh.listPrimitives().flatMap((primitive) => [...arrayOf(primitive, 'POSITION')])), 0);
}

/** A document with one mesh; `change` has a say in it. */
function documentOf({ positions, indices }, change = () => {}) {
  const document = quiet(new Document());
  const buffer = document.createBuffer();
  const add = (type, array) =>
    document.createAccessor().setType(type).setArray(array).setBuffer(buffer);
  const primitive = document.createPrimitive().setAttribute('POSITION', add('VEC3', positions))
    .setIndices(add('SCALAR', indices));
  const mesh = document.createMesh().addPrimitive(primitive);
  const node = document.createNode().setMesh(mesh);
  document.createScene().addChild(node);
  change({ document, mesh, node, primitive, add });
  return document;
}

test('what it makes of a file is what remeshFile makes of it, bit for bit', async () => {
  const document = await opened(file.bytes);
  await document.transform(remesh({ vertices: 1500 }));
  const bytes = await io.writeBinary(document);
  const { bytes: expected } = await remeshFile(file.bytes, { name: 'a.glb', vertices: 1500 });
  const [ours, theirs] = [bytes, expected].map((one) => opened(one));
  const [own, others] = [primitivesOf(await ours), primitivesOf(await theirs)];
  assert.equal(own.length, 3);
  own.forEach((primitive, i) => {
    assert.deepEqual(primitive.listSemantics(), others[i].listSemantics());
    for (const semantic of primitive.listSemantics()) {
      assert.deepEqual(arrayOf(primitive, semantic), arrayOf(others[i], semantic), semantic);
    }
    assert.deepEqual(primitive.getIndices().getArray(), others[i].getIndices().getArray());
    primitive.listTargets().forEach((target, k) => assert.deepEqual(
      arrayOf(target, 'POSITION'), arrayOf(others[i].listTargets()[k], 'POSITION')));
  });
  assert.equal(countOf(document), 1500);
  assert.deepEqual(await validate({ bytes }), []);
});

test('what is not geometry stays, and nothing old is left behind', async () => {
  const document = await opened(file.bytes);
  const root = document.getRoot();
  const before = primitivesOf(document).map((primitive) => ({
    primitive, material: primitive.getMaterial(),
    types: primitive.listSemantics().map((semantic) => {
      const accessor = primitive.getAttribute(semantic);
      return [semantic, accessor.getComponentType(), accessor.getNormalized(), accessor.getType()];
    }),
  }));
  const counts = () => [root.listAccessors(), root.listNodes(), root.listSkins(),
    root.listTextures(), root.listMaterials(), root.listMeshes()].map(({ length }) => length);
  const countsBefore = counts();
  await document.transform(remesh({ vertices: 1200 }));
  assert.deepEqual(counts(), countsBefore);
  primitivesOf(document).forEach((primitive, i) => {
    assert.equal(primitive, before[i].primitive);
    assert.equal(primitive.getMaterial(), before[i].material);
    assert.deepEqual(primitive.listSemantics().map((semantic) => {
      const accessor = primitive.getAttribute(semantic);
      return [semantic, accessor.getComponentType(), accessor.getNormalized(), accessor.getType()];
    }), before[i].types);
  });
  assert.deepEqual(root.listMeshes()[0].getExtras(), { targetNames: ['lean'] });
});

test('it has a name, and works beside other transforms', async () => {
  assert.equal(remesh().name, 'remesh');
  const document = await opened(file.bytes);
  await document.transform(dedup(), weld(), dequantize(), remesh({ vertices: 2000 }),
    simplify({ simplifier: MeshoptSimplifier, ratio: 0.5, error: 0.05 }), prune());
  assert.ok(countOf(document) < 2000);
  await document.transform(remesh({ vertices: 900 }), quantize());
  assert.deepEqual(await validate({ bytes: await io.writeBinary(document) }), []);
});

test('quantised positions stay so where they are fine enough', async () => {
  for (const [Kind, one, Expected] of [[Int16Array, 32767, Int16Array],
    [Int8Array, 127, Float32Array]]) {
    const document = documentOf(torus(), ({ primitive }) => {
      const position = primitive.getAttribute('POSITION');
      position.setArray(Kind.from(position.getArray(), (x) => (x / 4) * one)).setNormalized(true);
    });
    await document.transform(remesh({ vertices: 600 }));
    const positions = arrayOf(primitivesOf(document)[0], 'POSITION');
    assert.deepEqual([positions.constructor, positions.length], [Expected, 3 * 600]);
  }
});

test('strips and fans become triangles, points and lines stay', async () => {
  const n = 12;
  const document = documentOf(sheet(n), ({ document: doc, mesh, primitive, add }) => {
    const strip = [];
    for (let i = 0; i < n; i += 1) {
      const rows = Array.from({ length: n + 1 }, (_, j) =>
        [i * (n + 1) + j, (i + 1) * (n + 1) + j]).flat();
      strip.push(...(i > 0 ? [strip.at(-1), rows[0]] : []), ...rows);
    }
    primitive.setMode(5).setIndices(add('SCALAR', Uint16Array.from(strip)));
    mesh.addPrimitive(doc.createPrimitive().setMode(0)
      .setAttribute('POSITION', primitive.getAttribute('POSITION')));
  });
  const [, points] = primitivesOf(document);
  const cloud = points.getAttribute('POSITION');
  await document.transform(remesh({ vertices: 200 }));
  const [surface, same] = primitivesOf(document);
  assert.deepEqual([surface.getMode(), same.getMode()], [4, 0]);
  assert.equal(same.getAttribute('POSITION'), cloud);
  assert.equal(arrayOf(surface, 'POSITION').length / 3, 200);
});

test('instances count where vertices are shared out', async () => {
  const document = documentOf(torus(), ({ document: doc, node, add }) => {
    const other = torus();
    const mesh = doc.createMesh().addPrimitive(doc.createPrimitive()
      .setAttribute('POSITION', add('VEC3', other.positions))
      .setIndices(add('SCALAR', other.indices)));
    doc.getRoot().listScenes()[0].addChild(doc.createNode().setMesh(mesh));
    const extension = doc.createExtension(EXTMeshGPUInstancing);
    node.setExtension('EXT_mesh_gpu_instancing', extension.createInstancedMesh()
      .setAttribute('SCALE', add('VEC3', new Float32Array([2, 2, 2]))));
  });
  await document.transform(remesh({ vertices: 2000 }));
  const [first, second] = primitivesOf(document).map((primitive) =>
    arrayOf(primitive, 'POSITION').length / 3);
  assert.ok(Math.abs(first / second - 4) < 0.02, `${first} and ${second}`);
});

test('a primitive that two meshes share becomes one for each', async () => {
  const document = documentOf(torus(), ({ document: doc, primitive }) => {
    const mesh = doc.createMesh().addPrimitive(primitive);
    doc.getRoot().listScenes()[0].addChild(doc.createNode().setMesh(mesh).setScale([3, 3, 3]));
  });
  await document.transform(remesh({ vertices: 2000 }));
  const [first, second] = primitivesOf(document);
  assert.notEqual(first, second);
  assert.equal(countOf(document), 2000);
});

test('what cannot be is refused in a sentence, and changes nothing', async () => {
  assert.throws(() => remesh({ vertexes: 5 }), { code: 'UNKNOWN_OPTION' });
  const document = documentOf(torus({ columns: 8, rows: 6 }));
  const before = arrayOf(primitivesOf(document)[0], 'POSITION');
  await assert.rejects(document.transform(remesh({ vertices: 1 })), RemeshError);
  await assert.rejects(document.transform(remesh({ signal: AbortSignal.abort() })),
    { name: 'AbortError' });
  assert.equal(arrayOf(primitivesOf(document)[0], 'POSITION'), before);
  primitivesOf(document)[0].getIndices().setArray(new Uint16Array([0, 1, 48]));
  await assert.rejects(document.transform(remesh()), { code: 'INDEX_OUT_OF_RANGE' });
  await quiet(new Document()).transform(remesh());
});

test('quads are two triangles in a row each, which the extras of their primitive say', async () => {
  const document = documentOf(torus(), ({ primitive }) => primitive.setExtras({ of: 'gold' }));
  await document.transform(remesh({ quads: true, vertices: 600 }));
  const [primitive] = primitivesOf(document);
  assert.deepEqual(primitive.getExtras(), { of: 'gold', quads: true });
  const corners = primitive.getIndices().getArray();
  const edges = new Map();
  for (let i = 0; i < corners.length; i += 6) {
    const [a, b, c, again, same, d] = corners.subarray(i, i + 6);
    assert.deepEqual([again, same], [a, c]);
    [a, b, c, d].forEach((from, k, all) => {
      const edge = [from, all[(k + 1) % 4]].sort((x, y) => x - y).join();
      edges.set(edge, (edges.get(edge) ?? 0) + 1);
    });
  }
  assert.ok([...edges.values()].every((count) => count === 2));
  const reread = await opened(await io.writeBinary(document));
  assert.equal(primitivesOf(reread)[0].getExtras().quads, true);
  await document.transform(remesh({ vertices: 500 }));
  assert.equal(primitivesOf(document)[0].getExtras().quads, false);
});
