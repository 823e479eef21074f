// SPDX-License-Identifier: MIT
// Formats of printing and simulation through the package: 3MF in its ZIP, Gmsh, VTU, Abaqus.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { strFromU8, strToU8, unzipSync, zipSync } from 'fflate';
import { convertFile, inspect, remeshFile, repairFile } from 'remesher';

import { rejectsWith } from '../support/errors.js';
import { GltfMaker } from '../support/gltf.js';
import { offText, torus } from '../support/shapes.js';

const off = new TextEncoder().encode(offText(torus()));
const made = (output, options = {}) => remeshFile(off, { name: 'ring.off', output, vertices: 300,
  ...options });

test('a 3MF is a package that is read again, and the same at any time', async () => {
  const { bytes, name } = await made('3mf');
  assert.equal(name, 'ring.3mf');
  const entries = unzipSync(bytes);
  assert.deepEqual(Object.keys(entries).sort(),
    ['3D/3dmodel.model', '[Content_Types].xml', '_rels/.rels']);
  const { input } = await inspect(bytes, { name });
  assert.deepEqual([input.vertices, input.triangles, input.boundaryEdges], [300, 600, 0]);
  assert.deepEqual((await made('3mf')).bytes, bytes);
});

test('meshes that meet stay apart in a 3MF, and are counted so', async () => {
  const maker = new GltfMaker();
  const meshes = [[0, 1], [1, 2]].map(([left, right]) => ({ primitives: [{
    attributes: { POSITION: maker.add(
      Float32Array.of(left, 0, 0, right, 0, 0, right, 1, 0, left, 1, 0), 'VEC3') },
    indices: maker.addIndices(Uint16Array.of(0, 1, 2, 0, 2, 3)),
  }] }));
  maker.show(meshes[0].primitives);
  Object.assign(maker.tree, { meshes, nodes: [{ mesh: 0 }, { mesh: 1 }] });
  maker.tree.scenes[0].nodes = [0, 1];
  const halves = maker.glb();
  const { bytes, name, report } = await remeshFile(halves.bytes,
    { name: halves.name, output: '3mf', vertices: 40 });
  const { input } = await inspect(bytes, { name });
  for (const figure of ['vertices', 'triangles', 'components', 'boundaryEdges']) {
    assert.equal(report.output[figure], input[figure], figure);
  }
});

test('a sound 3MF comes back from repair byte for byte, all of its package', async () => {
  const entries = unzipSync((await made('3mf')).bytes);
  const bytes = zipSync({ ...entries, 'Metadata/thumbnail.png': new Uint8Array(10) });
  const repaired = await repairFile(bytes, { name: 'a.3mf' });
  assert.deepEqual(repaired.bytes, bytes);
});

test('a package is known by its bytes; its relationship and its paths are followed', async () => {
  const entries = unzipSync((await made('3mf')).bytes);
  const object = strFromU8(entries['3D/3dmodel.model']);
  const start = object.replace(/<object[^]*<\/object>/, '<object id="9"><components>'
    + '<component p:path="/3D/Objects/ring.model" objectid="2"/></components></object>')
    .replace('objectid="2"/>\n</build>', 'objectid="9"/>\n</build>');
  const bytes = zipSync({
    '_rels/.rels': strToU8(strFromU8(entries['_rels/.rels']).replace('3D/3dmodel', 'start')),
    'start.model': strToU8(start),
    '3D/Objects/ring.model': strToU8(object),
  });
  assert.equal((await inspect(bytes, { name: 'ring.stl' })).input.triangles, 600);
});


test('damaged and foreign packages are refused in a sentence', async () => {
  const { bytes } = await made('3mf');
  await rejectsWith(inspect(bytes.slice(0, bytes.length - 40), { name: 'a.3mf' }),
    'PARSE_ERROR', /ZIP is damaged/);
  await rejectsWith(inspect(zipSync({ 'a.txt': strToU8('x') }), { name: 'a.zip' }),
    'UNKNOWN_FORMAT', /ZIP archive/);
});

for (const output of ['msh', 'vtu']) {
  test(`quads go to .${output} and come back`, async () => {
    const { bytes, name, report } = await made(output, { quads: true });
    const back = await convertFile(bytes, { name, output: 'obj' });
    const faces = new TextDecoder().decode(back.bytes).match(/^f .*$/gm) ?? [];
    assert.equal(faces.length, report.output.quads.count);
    assert.ok(faces.every((face) => face.split(' ').length === 5));
  });
}

test('Abaqus input has a node a line and its elements by set', async () => {
  const text = new TextDecoder().decode((await made('inp')).bytes);
  assert.equal(text.match(/^\d+, \S+, \S+, \S+$/gm)?.length, 300 + 600);
  assert.match(text, /\*ELEMENT, TYPE=S3, ELSET=/);
  await rejectsWith(inspect(new TextEncoder().encode(text), { name: 'a.inp' }), 'UNKNOWN_FORMAT',
    /only written/);
});
