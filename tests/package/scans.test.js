// SPDX-License-Identifier: MIT
// PLY and STL as others write them, and ours as others read them: three.js both ways, and the
// layouts that MeshLab and CGAL are known by.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { convertFile, inspect, remeshFile } from 'remesher';
import {
  BufferAttribute, BufferGeometry, Color, Mesh, SRGBColorSpace,
} from 'three';
import { PLYExporter } from 'three/addons/exporters/PLYExporter.js';
import { STLExporter } from 'three/addons/exporters/STLExporter.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';
import { STLLoader } from 'three/addons/loaders/STLLoader.js';

import { validate } from '../support/gltf.js';
import { offText, plyText, torus } from '../support/shapes.js';

const encode = (text) => new TextEncoder().encode(text);
const decode = (bytes) => new TextDecoder('latin1').decode(bytes);
const bufferOf = (bytes) => bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);

/** A torus whose colour says where a vertex is: red and green grow along x and y. */
function colored() {
  const { positions, indices } = torus();
  const count = positions.length / 3;
  const [colors, texcoords] = [new Float32Array(3 * count), new Float32Array(2 * count)];
  const color = new Color();
  for (let i = 0; i < count; i += 1) {
    const [x, y] = positions.subarray(3 * i, 3 * i + 2);
    color.setRGB((x + 3) / 6, (y + 3) / 6, 0.2, SRGBColorSpace).toArray(colors, 3 * i);
    texcoords.set([(x + 3) / 6, (y + 3) / 6], 2 * i);
  }
  const geometry = new BufferGeometry().setIndex(new BufferAttribute(indices, 1))
    .setAttribute('position', new BufferAttribute(positions, 3))
    .setAttribute('color', new BufferAttribute(colors, 3))
    .setAttribute('uv', new BufferAttribute(texcoords, 2));
  geometry.computeVertexNormals();
  return new Mesh(geometry);
}

const threePly = (options) => {
  const written = new PLYExporter().parse(colored(), null, options);
  return typeof written === 'string' ? encode(written) : new Uint8Array(written);
};
const threeStl = (options) => {
  const written = new STLExporter().parse(colored(), options);
  return typeof written === 'string' ? encode(written) : new Uint8Array(written.buffer);
};

const fromThree = {
  'a PLY in text': ['t.ply', threePly({})],
  'a binary PLY': ['t.ply', threePly({ binary: true, littleEndian: true })],
  'a PLY with the other order of bytes': ['t.ply', threePly({ binary: true })],
  'an STL in text': ['t.stl', threeStl({})],
  'a binary STL': ['t.stl', threeStl({ binary: true })],
};

for (const [what, [name, bytes]] of Object.entries(fromThree)) {
  test(`${what} of three.js is read as the closed torus it is`, async () => {
    const { input, warnings } = await inspect(bytes, { name });
    const { vertices, triangles, eulerCharacteristic, boundaryEdges } = input;
    assert.deepEqual({ vertices, triangles, eulerCharacteristic, boundaryEdges },
      { vertices: 48 * 24, triangles: 2 * 48 * 24, eulerCharacteristic: 0, boundaryEdges: 0 });
    assert.deepEqual(warnings, []);
  });

  test(`${what} is read without its extension`, async () => {
    if (what === 'a binary STL') return; // whose header says nothing
    const { input } = await inspect(bytes);
    assert.equal(input.triangles, 2 * 48 * 24);
  });

  test(`${what}, remeshed, is what three.js reads`, async () => {
    const result = await remeshFile(bytes, { name, vertices: 600 });
    assert.equal(result.name, name);
    const loader = name === 't.ply' ? new PLYLoader() : new STLLoader();
    const geometry = loader.parse(bufferOf(result.bytes));
    const count = geometry.index ? geometry.index.count : geometry.attributes.position.count;
    assert.equal(count / 3, 1200);
    if (name === 't.stl') return;
    const { position, color, uv, normal } = geometry.attributes;
    assert.equal(position.count, 600);
    const now = new Color();
    for (let i = 0; i < position.count; i += 1) {
      const [x, y] = [(position.getX(i) + 3) / 6, (position.getY(i) + 3) / 6];
      const { r, g } = now.fromBufferAttribute(color, i).getRGB({}, SRGBColorSpace);
      // One step of a byte; the rest is how far a vertex may be from the triangle it was on.
      assert.ok(Math.hypot(r - x, g - y) < 0.02, `the colour of vertex ${i} has moved`);
      assert.ok(Math.hypot(uv.getX(i) - x, uv.getY(i) - y) < 0.02, 'its texture has moved');
      const length = Math.hypot(normal.getX(i), normal.getY(i), normal.getZ(i));
      assert.ok(Math.abs(length - 1) < 1e-5);
    }
  });
}

test('a PLY keeps its encoding, the order and the types of its properties', async () => {
  for (const options of [{}, { binary: true }, { binary: true, littleEndian: true }]) {
    const bytes = threePly(options);
    const properties = (text) => decode(text).match(/^(format|property) .*$/gm);
    const result = await remeshFile(bytes, { name: 't.ply', vertices: 600 });
    assert.deepEqual(properties(result.bytes), properties(bytes));
    const same = await convertFile(bytes, { name: 't.ply', output: 'again.ply' });
    assert.deepEqual(same.bytes, bytes);
  }
});

/** The vertices of a binary PLY of places and colours in bytes alone. */
function rowsOf(bytes) {
  const start = decode(bytes).indexOf('end_header\n') + 'end_header\n'.length;
  assert.match(decode(bytes.subarray(0, start)),
    /float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty uchar green\n/);
  const view = new DataView(bufferOf(bytes));
  return Array.from({ length: torus().positions.length / 3 }, (_, i) => ({
    place: [0, 4, 8].map((k) => view.getFloat32(start + 15 * i + k, true)),
    color: Array.from(bytes.subarray(start + 15 * i + 12, start + 15 * i + 15)),
  }));
}

test('a glTF of a PLY has its colours linear, and gives the same numbers back', async () => {
  const { positions, indices } = torus();
  const colors = Array.from({ length: positions.length / 3 }, (_, i) => [i % 256, 188, 255]);
  const [head, body] = plyText({ positions, indices }).split('end_header\n');
  const names = ['red', 'green', 'blue'].map((name) => `property uchar ${name}\n`).join('');
  const rows = body.split('\n')
    .map((row, i) => (i in colors ? `${row} ${colors[i].join(' ')}` : row));
  const text = `${head.replace('float z\n', `float z\n${names}`)}end_header\n${rows.join('\n')}`;
  const gltf = await convertFile(encode(text), { name: 't.ply', output: 't.glb' });
  assert.deepEqual(await validate(gltf), []);
  const { mesh } = await new GLTFLoader().parseAsync(bufferOf(gltf.bytes), '')
    .then(({ scene }) => ({ mesh: scene.getObjectByProperty('isMesh', true) }));
  // 188 of 255 in sRGB is half of the light.
  assert.ok(Math.abs(mesh.geometry.attributes.color.getY(0) - 0.5) < 0.005);
  const { bytes } = await convertFile(gltf.bytes, { name: 't.glb', output: 'back.ply' });
  rowsOf(bytes).forEach(({ place, color }, i) => {
    assert.deepEqual(color, colors[i]);
    assert.deepEqual(place, Array.from(positions.subarray(3 * i, 3 * i + 3)));
  });
});

const corners = (bytes) => {
  const view = new DataView(bufferOf(bytes));
  return Array.from({ length: view.getUint32(80, true) }, (_, i) =>
    bytes.slice(84 + 50 * i + 12, 84 + 50 * i + 48));
};

test('an STL read and written has the same corners, bit for bit', async () => {
  const bytes = threeStl({ binary: true });
  const result = await convertFile(bytes, { name: 't.stl', output: 'again.stl' });
  assert.deepEqual(corners(result.bytes), corners(bytes));
  assert.match(decode(result.bytes.subarray(0, 80)), /remesher/);
});

test('a scene of several parts is one solid', async () => {
  const { positions, indices } = torus();
  const part = (name, first) => [
    `o ${name}`,
    ...Array.from({ length: positions.length / 3 }, (_, i) =>
      `v ${positions[3 * i] + 10 * first} ${positions[3 * i + 1]} ${positions[3 * i + 2]}`),
    ...Array.from({ length: indices.length / 3 }, (_, i) => `f ${[0, 1, 2]
      .map((k) => indices[3 * i + k] + 1 + (first * positions.length) / 3).join(' ')}`),
  ];
  const obj = encode([...part('left', 0), ...part('right', 1)].join('\n'));
  const { bytes, report } = await remeshFile(obj, { name: 'a.obj', output: 'stl', vertices: 1000 });
  const { input } = await inspect(bytes, { name: 'a.stl' });
  assert.equal(input.components, 2);
  assert.equal(input.vertices, 1000);
  assert.ok(report.warnings.some(({ code }) => code === 'PARTS_MERGED'));
});

/** What MeshLab writes of a textured scan: flags, quality, and texture per corner. */
function meshLabPly() {
  const { positions, indices } = torus();
  const lines = ['ply', 'format ascii 1.0', 'comment VCGLIB generated',
    'comment TextureFile skin.png', `element vertex ${positions.length / 3}`,
    'property float x', 'property float y', 'property float z', 'property int flags',
    'property float quality', `element face ${indices.length / 3}`,
    'property list uchar int vertex_indices', 'property int flags',
    'property list uchar float texcoord', 'property int texnumber', 'end_header'];
  const at = (v) => Array.from(positions.subarray(3 * v, 3 * v + 3));
  for (let v = 0; v < positions.length / 3; v += 1) lines.push(`${at(v).join(' ')} 0 ${at(v)[0]}`);
  for (let i = 0; i < indices.length; i += 3) {
    const face = Array.from(indices.subarray(i, i + 3));
    // Two charts, the left and the right half, side by side.
    const shift = face.reduce((sum, v) => sum + at(v)[0], 0) > 0 ? 0.5 : 0;
    const texcoords = face.flatMap((v) => [(at(v)[0] + 3) / 12 + shift, (at(v)[1] + 3) / 6]);
    lines.push(`3 ${face.join(' ')} 0 6 ${texcoords.join(' ')} 0`);
  }
  return encode(`${lines.join('\n')}\n`);
}

test('a scan of MeshLab comes back textured per corner, closed, its quality in place', async () => {
  const { bytes, report } = await remeshFile(meshLabPly(), { name: 'scan.ply', vertices: 800 });
  assert.ok(report.warnings.some(({ message }) => message.includes('flags')));
  const [head, body] = decode(bytes).split('end_header\n');
  for (const line of ['comment TextureFile skin.png', 'element vertex 800', 'property int flags',
    'property list uchar float texcoord', 'property int texnumber']) {
    assert.ok(head.includes(`${line}\n`), line);
  }
  const rows = body.trim().split('\n').map((line) => line.split(' ').map(Number));
  const [vertices, faces] = [rows.slice(0, 800), rows.slice(800)];
  // Vertices leave the triangle they take their values from, by less than a hundredth of the size.
  for (const [x, , , flags, quality] of vertices) {
    assert.ok(flags === 0 && Math.abs(quality - x) < 0.06, `${quality} at ${x}`);
  }
  for (const [, a, b, c, six, ...rest] of faces) {
    assert.equal(six, 6);
    const shift = rest[0] - (vertices[a][0] + 3) / 12 > 0.25 ? 0.5 : 0;
    [a, b, c].forEach((v, k) => {
      const [x, y] = vertices[v];
      const [u, t] = rest.slice(2 * k);
      assert.ok(Math.hypot(u - (x + 3) / 12 - shift, t - (y + 3) / 6) < 0.02,
        'no triangle takes its texture from two charts');
    });
  }
});

test('what CGAL writes beside vertices and faces is passed over', async () => {
  const [, counts, ...rows] = offText(torus()).trim().split('\n');
  const [vertices, faces] = counts.split(' ').map(Number);
  const text = ['ply', 'format ascii 1.0',
    'comment Generated by the CGAL library', `element vertex ${vertices}`, 'property double x',
    'property double y', 'property double z', `element face ${faces}`,
    'property list uchar int vertex_indices', 'element edge 1', 'property int v0',
    'property int v1', 'property uchar is_feature', 'element halfedge 1', 'property int source',
    'property int target', 'end_header', ...rows, '0 1 1', '0 1'].join('\n');
  const { input, warnings } = await inspect(encode(text), { name: 'cgal.ply' });
  assert.equal(input.eulerCharacteristic, 0);
  assert.match(warnings[0].message, /edge, halfedge/);
});
