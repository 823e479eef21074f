// SPDX-License-Identifier: MIT
// An OBJ with its material library, by command line: groups, materials, texture and normals come
// back, and no triangle takes its texture from two charts.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';

import { addChart, columns, layOut, place, rows, texels, wide } from '../support/atlas_torus.js';
import { eulerCharacteristic } from '../support/shapes.js';
import { root } from '../support/tree.js';

const folder = mkdtempSync(join(tmpdir(), 'remesher-obj-'));
after(() => rmSync(folder, { recursive: true }));

const charts = layOut(wide);
const library = 'newmtl dark red\nKd 0.5 0 0\nmap_Kd paint.png\nnewmtl plain\nKd 1 1 1\n';
const materialOf = (chart) => ['dark red', 'plain'][chart % 2];

/** Away from the middle of the tube, whose radius around the z axis is 2. */
function normalAt([x, y, z]) {
  const radius = Math.hypot(x, y);
  const out = [x - (2 * x) / radius, y - (2 * y) / radius, z];
  return out.map((value) => value / Math.hypot(...out));
}

/** Places and normals once each, texture coordinates once per chart; a group for every chart. */
function atlasObj() {
  const vertices = new Map();
  const [lines, faces] = [['mtllib paint.mtl'], []];
  let first = 1;
  charts.forEach((chart, number) => {
    const mesh = { positions: [], texcoords: [], indices: [] };
    addChart(mesh, chart);
    const places = Array.from({ length: mesh.positions.length / 3 }, (_, v) =>
      mesh.positions.slice(3 * v, 3 * v + 3));
    for (const point of places) {
      if (vertices.has(String(point))) continue;
      vertices.set(String(point), vertices.size + 1);
      lines.push(`v ${point.join(' ')}`, `vn ${normalAt(point).join(' ')}`);
    }
    places.forEach((_, v) =>
      lines.push(`vt ${mesh.texcoords[2 * v]} ${1 - mesh.texcoords[2 * v + 1]}`));
    faces.push(`g chart${number} part`, `usemtl ${materialOf(number)}`);
    for (let t = 0; t < mesh.indices.length; t += 3) {
      faces.push(`f ${mesh.indices.slice(t, t + 3).map((v) => {
        const vertex = vertices.get(String(places[v]));
        return `${vertex}/${first + v}/${vertex}`;
      }).join(' ')}`);
    }
    first += places.length;
  });
  assert.equal(vertices.size, columns * rows);
  return `${[...lines, ...faces].join('\n')}\n`;
}

/** Vertices, texture coordinates and normals; faces as numbers of them, with group and material. */
function parse(text) {
  const model = { v: [], vt: [], vn: [], faces: [] };
  const now = { g: '', usemtl: '' };
  for (const [keyword, ...words] of text.split('\n').map((line) => line.split(' '))) {
    if (keyword in model) model[keyword].push(words.map(Number));
    if (keyword in now) now[keyword] = words.join(' ');
    if (keyword !== 'f') continue;
    const corners = words.map((word) => word.split('/').map((number) => number - 1));
    model.faces.push({ group: now.g, material: now.usemtl, corners });
  }
  return model;
}

/** Where on the torus a chart has a texture coordinate. */
function placeOf({ i0, i1, j0, j1, left, top, width, height }, [u, v]) {
  const [across, down] = [(u * texels - left) / width, ((1 - v) * texels - top) / height];
  assert.ok(Math.min(across, down) > -1e-6 && Math.max(across, down) < 1 + 1e-6,
    `${u}, ${v} is outside its chart`);
  return place(i0 + across * (i1 - i0), j0 + down * (j1 - j0));
}

test('an OBJ comes back with its groups, materials, normals, and texture in place', () => {
  mkdirSync(join(folder, 'out'));
  writeFileSync(join(folder, 'torus.obj'), atlasObj());
  writeFileSync(join(folder, 'paint.mtl'), library);
  const { status, stderr } = spawnSync(process.execPath, [join(root, 'dist/cli/cli.js'),
    'torus.obj', '-o', 'out/torus.obj', '--vertices', '1500', '--quiet'],
  { cwd: folder, encoding: 'utf8' });
  assert.equal(status, 0, stderr);
  const text = readFileSync(join(folder, 'out/torus.obj'), 'utf8');
  assert.match(text, /^mtllib paint.mtl$/m);
  assert.equal(readFileSync(join(folder, 'out/paint.mtl'), 'utf8'), library);

  const { v, vt, vn, faces } = parse(text);
  assert.equal(v.length, 1500);
  // Closed as it was: seams are no cracks.
  assert.equal(faces.length, 3000);
  const indices = faces.flatMap(({ corners }) => corners.map(([vertex]) => vertex));
  assert.equal(eulerCharacteristic({ positions: v.flat(), indices }), 0);
  assert.deepEqual(new Set(faces.map(({ group }) => group)),
    new Set(charts.map((_, number) => `chart${number} part`)));
  for (const { group, material, corners } of faces) {
    const number = Number(/\d+/.exec(group));
    assert.equal(material, materialOf(number));
    for (const [vertex, texcoord, normal] of corners) {
      const there = placeOf(charts[number], vt[texcoord]);
      // A rounding of the tube by 32 sides is 0.004 deep.
      assert.ok(Math.hypot(...there.map((x, k) => x - v[vertex][k])) < 0.02, `${group} moved`);
      const cosine = normalAt(v[vertex]).reduce((sum, x, k) => sum + x * vn[normal][k], 0);
      assert.ok(cosine > 0.999, `a normal is off: ${cosine}`);
    }
  }
});
