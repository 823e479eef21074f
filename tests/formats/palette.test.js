// SPDX-License-Identifier: MIT
// Every colour of a palette is where it was: the vertices of a file go first to the parts whose
// charts would be lost, then to those that are large.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { inspect, remeshFile } from 'remesher';
import { Line3, Vector3 } from 'three';

import { openGltf, valuesOf } from '../support/gltf.js';
import { NearestPoints, vertexOf } from '../support/nearest.js';
import { boxes, colourAt, paintedBoxes } from '../support/painted_boxes.js';

const made = paintedBoxes();
const steps = 4;  // samples along a triangle's side
const near = 0.01;  // of a border it may be either colour; the smallest box is 0.3 wide

/** Edges with another colour, or another side of the box, beyond them. */
function borders({ positions, indices, colours }) {
  const beyond = new Map();
  const corner = (v) => vertexOf(positions, v).toArray().map((x) => Math.round(x * 1e6)).join();
  for (let t = 0; t < colours.length; t += 1) {
    const plane = [0, 1, 2].find((axis) => new Set([0, 1, 2].map((k) =>
      positions[3 * indices[3 * t + k] + axis])).size === 1);
    for (let k = 0; k < 3; k += 1) {
      const [a, b] = [indices[3 * t + k], indices[3 * t + ((k + 1) % 3)]];
      const key = [corner(a), corner(b)].sort().join(' ');
      const line = new Line3(vertexOf(positions, a), vertexOf(positions, b));
      const { shown = new Set() } = beyond.get(key) ?? {};
      beyond.set(key, { line, shown: shown.add(`${plane} ${colours[t]}`) });
    }
  }
  return [...beyond.values()].filter(({ shown }) => shown.size > 1).map(({ line }) => line);
}

/** Points all over the box, away from borders, each with its colour. */
function samples(mesh) {
  const lines = borders(mesh);
  const closest = new Vector3();
  return mesh.colours.flatMap((colour, t) => {
    const [a, b, c] = [0, 1, 2].map((k) => vertexOf(mesh.positions, mesh.indices[3 * t + k]));
    const points = [];
    for (let i = 0; i <= steps; i += 1) {
      for (let j = 0; i + j <= steps; j += 1) {
        const point = new Vector3().addScaledVector(a, i / steps).addScaledVector(b, j / steps)
          .addScaledVector(c, 1 - (i + j) / steps);
        if (lines.every((line) => line.closestPointToPoint(point, true, closest)
          .distanceTo(point) > near)) points.push({ point, colour });
      }
    }
    return points;
  });
}

/** How many places of each box have another colour than they had. */
function strangers(file) {
  return boxes.map(({ mesh }, part) => {
    const { attributes, indices } = file.tree.meshes[part].primitives[0];
    const uv = valuesOf(file, attributes.TEXCOORD_0);
    const result = new NearestPoints({
      positions: valuesOf(file, attributes.POSITION).flat(),
      indices: valuesOf(file, indices).flat(),
    });
    return samples(mesh).filter(({ point, colour }) => {
      const { corners, weights } = result.find(point).places[0];
      return colourAt([weights.reduce((sum, w, k) => sum + w * uv[corners[k]][0], 0)]) !== colour;
    }).length;
  });
}

const { input } = await inspect(made.bytes, { name: made.name });

/** The figure with a share of its vertices, and how many places of each box went astray. */
async function strangersAt(share) {
  const vertices = Math.round(share * input.vertices);
  const result = await remeshFile(made.bytes, { name: made.name, vertices });
  assert.equal(result.report.output.vertices, vertices);
  return strangers(openGltf(result));
}

for (const [share, words] of [[1, 'its own number'], [0.75, 'three quarters of it']]) {
  test(`a figure of painted boxes keeps every colour in its place with ${words}`, async () => {
    assert.deepEqual(await strangersAt(share), boxes.map(() => 0));
  });
}

// A head whose triangles are as small as its eyes would take more than three quarters of all.
test('with half of it every box but the head, which costs most, keeps its colours', async () => {
  const [, ...others] = await strangersAt(0.5);
  assert.deepEqual(others, others.map(() => 0));
});
