// SPDX-License-Identifier: MIT
// Files of every format through the whole package: in as one, out as another, and what is refused.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { inspect, remeshFile } from 'remesher';
import { readFormats } from 'remesher/formats';

import { rejectsWith } from '../support/errors.js';
import { GltfMaker, openGltf, validate } from '../support/gltf.js';
import { offText, plyText, sheet, stl, torus } from '../support/shapes.js';

const encode = (text) => new TextEncoder().encode(text);
const decode = (bytes) => new TextDecoder().decode(bytes);

/** An OBJ of two materials, with texture coordinates and normals. */
function objText({ positions, indices }) {
  const lines = ['mtllib paint.mtl'];
  for (let i = 0; i < positions.length; i += 3) {
    const [x, y, z] = positions.subarray(i, i + 3);
    lines.push(`v ${x} ${y} ${z}`, `vt ${x} ${y}`, 'vn 0 0 1');
  }
  const half = Math.floor(indices.length / 6) * 3;
  for (let i = 0; i < indices.length; i += 3) {
    if (i === 0) lines.push('o cloth', 'usemtl red');
    if (i === half) lines.push('usemtl blue paint');
    const corners = [...indices.subarray(i, i + 3)].map((v) => [v + 1, v + 1, v + 1].join('/'));
    lines.push(`f ${corners.join(' ')}`);
  }
  return `${lines.join('\n')}\n`;
}

function glb({ positions, indices }) {
  const maker = new GltfMaker();
  return maker.show([{
    attributes: { POSITION: maker.add(positions, 'VEC3') },
    indices: maker.addIndices(indices),
  }]).glb().bytes;
}

const inputs = {
  off: encode(offText(torus())),
  obj: encode(offText(torus()).split('\n').slice(2)
    .map((line) => (line.startsWith('3 ')
      ? `f ${line.split(' ').slice(1).map((v) => Number(v) + 1).join(' ')}` : `v ${line}`))
    .slice(0, -1).join('\n')),
  glb: glb(torus()),
  ply: encode(plyText(torus())),
  stl: stl(torus()),
};

for (const [from, bytes] of Object.entries(inputs)) {
  for (const to of readFormats) {
    test(`${from} becomes ${to}, with the vertices asked for and the same topology`, async () => {
      const result = await remeshFile(bytes, { name: `torus.${from}`, output: to, vertices: 500 });
      assert.equal(result.name, `torus.${to}`);
      if (to.startsWith('gl')) assert.deepEqual(await validate(result), []);
      const resources = Object.fromEntries(result.files.slice(1).map((f) => [f.name, f.bytes]));
      const { input } = await inspect(result.bytes, { name: result.name, resources });
      assert.equal(input.vertices, 500);
      assert.equal(input.eulerCharacteristic, 0);
      assert.equal(input.boundaryEdges, 0);
    });
  }
}

test('an OBJ with texture, normals and materials comes back with the same', async () => {
  const library = encode('newmtl red\nnewmtl blue paint\n');
  const result = await remeshFile(encode(objText(sheet(24))),
    { name: 'cloth.obj', vertices: 400, resources: { 'paint.mtl': library } });
  const text = decode(result.bytes);
  for (const line of ['mtllib paint.mtl', 'o cloth', 'usemtl red', 'usemtl blue paint']) {
    assert.ok(text.includes(`${line}\n`), line);
  }
  assert.deepEqual(result.files[1].bytes, library);
  const list = (keyword) => text.split('\n').filter((line) => line.startsWith(`${keyword} `))
    .map((line) => line.split(' ').slice(1));
  const [places, texcoords, faces] = [list('v'), list('vt'), list('f')];
  assert.equal(places.length, 400);
  for (const [place, texcoord] of faces.flat().map((corner) => corner.split('/'))) {
    const [[x, y], [u, v]] = [places[place - 1], texcoords[texcoord - 1]];
    assert.ok(Math.hypot(x - u, y - v) < 0.01, `${u}, ${v} at ${x}, ${y}`);
  }
});

test('an OBJ becomes glTF with a primitive and a material for each usemtl', async () => {
  const result = await remeshFile(encode(objText(sheet(24))),
    { name: 'cloth.obj', output: 'glb', vertices: 400 });
  assert.deepEqual(await validate(result), []);
  const { tree } = openGltf(result);
  assert.deepEqual(tree.materials.map(({ name }) => name), ['red', 'blue paint']);
  assert.deepEqual(tree.meshes[0].primitives.map(({ material }) => material), [0, 1]);
});

const refused = {
  'an empty file': ['a.glb', new Uint8Array(), 'EMPTY_FILE'],
  'a text file named .glb': ['a.glb', encode('Dear diary, today was long.'), 'PARSE_ERROR'],
  'a truncated GLB': ['a.glb', inputs.glb.subarray(0, 1000), 'PARSE_ERROR'],
  'a cloud of points': ['a.ply', encode(plyText({ ...torus(), indices: [] })), 'NO_TRIANGLES'],
  'a PLY of four billion vertices': ['a.ply',
    encode(plyText(torus()).replace(/vertex \d+/, 'vertex 4294967294')), 'PARSE_ERROR'],
  'a truncated STL': ['a.stl', stl(torus()).subarray(0, 1000), 'PARSE_ERROR'],
  'an STL of four billion facets': ['a.stl', stl(torus()).fill(255, 80, 84), 'PARSE_ERROR'],
  'an OBJ without faces': ['a.obj', encode('v 0 0 0\nv 1 0 0\n'), 'NO_TRIANGLES'],
  'a NaN': ['a.obj', encode('v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n'), 'NON_FINITE'],
  'an infinity': ['a.off', encode('OFF\n3 1 0\n0 0 0\n1 inf 0\n0 1 0\n3 0 1 2\n'), 'NON_FINITE'],
  'an index out of range': ['a.obj', encode('v 0 0 0\nf 1 2 3\n'), 'INDEX_OUT_OF_RANGE'],
  'a text in UTF-16': ['a.obj',
    new Uint8Array(Uint16Array.of(0xFEFF, ...encode('v 0 0 0\n')).buffer), 'UNSUPPORTED'],
  'an unknown format': ['a.doc', encode('Hello'), 'UNKNOWN_FORMAT'],
};

for (const [what, [name, bytes, code]] of Object.entries(refused)) {
  test(`${what} is refused in a sentence`, async () => {
    await rejectsWith(remeshFile(bytes, { name, output: 'glb', vertices: 100 }), code, /^a\.\w+/);
  });
}

test('the list of formats is that of the core', async () => {
  await assert.rejects(inspect(encode('Hello'), { name: 'a.doc' }), ({ hint }) => {
    assert.deepEqual(hint.match(/\.\w+/g).sort(),
      readFormats.map((format) => `.${format}`).sort());
    return true;
  });
});

test('coordinates beyond single precision are refused by glTF, and kept by OBJ', async () => {
  const bytes = encode('v 1e39 0 0\nv 0 1e39 0\nv 0 0 1e39\nf 1 2 3\n');
  const options = { name: 'a.obj', vertices: 20 };
  await rejectsWith(remeshFile(bytes, { ...options, output: 'glb' }), 'UNSUPPORTED',
    /too large for glTF/);
  const { report } = await remeshFile(bytes, { ...options, output: 'off' });
  assert.ok(report.fidelity.hausdorff < 1e-6);
});
