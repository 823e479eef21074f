// SPDX-License-Identifier: MIT
// A textured model by formula: a glazed vase whose pattern is painted texel by texel.
import { Document, NodeIO } from '@gltf-transform/core';
import { encode } from 'fast-png';

const [columns, rows, texels, height] = [48, 40, 512, 1.5];

/** The outer radius at height v from 0 to 1. @param {number} v */
const radius = (v) => 0.34 + 0.26 * Math.sin(Math.PI * (1.12 * v + 0.08)) ** 2
  + 0.1 * Math.max(0, v - 0.8) * 5 * Math.max(0, v - 0.8) * 5 - 0.05 * v;

/** The derivative of the radius. @param {number} v */
const slope = (v) => 0.26 * 1.12 * Math.PI * Math.sin(2 * Math.PI * (1.12 * v + 0.08))
  + 5 * Math.max(0, v - 0.8) - 0.05;

/** Red, green and blue of the glaze: bands of diamonds over a blue ground.
 * @param {number} u @param {number} v in turns and heights */
function glaze(u, v) {
  const diamond = Math.abs((12 * u) % 1 - 0.5) + Math.abs((6 * v) % 1 - 0.5);
  const isBand = Math.abs(v - 0.5) < 0.17 || Math.abs(v - 0.94) < 0.03 || v < 0.06;
  if (!isBand) return [34 + 22 * v, 70 + 40 * v, 128 + 36 * v];
  return diamond < 0.32 ? [186, 74, 46] : [238, 226, 200];
}

function picture() {
  const data = new Uint8Array(3 * texels * texels);
  for (let y = 0; y < texels; ++y) {
    for (let x = 0; x < texels; ++x) {
      data.set(glaze((x + 0.5) / texels, 1 - (y + 0.5) / texels), 3 * (y * texels + x));
    }
  }
  return encode({ width: texels, height: texels, data, channels: 3 });
}

/** The first column of vertices exists twice, with u 0 and 1: the seam from bottom to top. */
function surface() {
  const positions = [], normals = [], texcoords = [], indices = [];
  for (let j = 0; j <= rows; ++j) {
    for (let i = 0; i <= columns; ++i) {
      const [u, v] = [i / columns, j / rows];
      const turn = 2 * Math.PI * (i % columns) / columns;
      positions.push(radius(v) * Math.cos(turn), height * v, -radius(v) * Math.sin(turn));
      const steep = Math.hypot(height, slope(v));
      normals.push(height * Math.cos(turn) / steep, -slope(v) / steep,
        -height * Math.sin(turn) / steep);
      texcoords.push(u, 1 - v);
      if (i === columns || j === rows) continue;
      const [a, b] = [j * (columns + 1) + i, (j + 1) * (columns + 1) + i];
      indices.push(a, a + 1, b + 1, a, b + 1, b);
    }
  }
  return { positions: Float32Array.from(positions), normals: Float32Array.from(normals),
    texcoords: Float32Array.from(texcoords), indices: Uint16Array.from(indices) };
}

/** @returns {Promise<Uint8Array>} a GLB */
export async function vase() {
  const document = new Document();
  const buffer = document.createBuffer();
  const { positions, normals, texcoords, indices } = surface();
  const accessor = () => document.createAccessor().setBuffer(buffer);
  const texture = document.createTexture('glaze').setMimeType('image/png').setImage(picture());
  const material = document.createMaterial('glaze').setBaseColorTexture(texture)
    .setRoughnessFactor(0.35).setMetallicFactor(0).setDoubleSided(true);
  const primitive = document.createPrimitive().setMaterial(material)
    .setAttribute('POSITION', accessor().setType('VEC3').setArray(positions))
    .setAttribute('NORMAL', accessor().setType('VEC3').setArray(normals))
    .setAttribute('TEXCOORD_0', accessor().setType('VEC2').setArray(texcoords))
    .setIndices(accessor().setType('SCALAR').setArray(indices));
  const mesh = document.createMesh('vase').addPrimitive(primitive);
  document.createScene().addChild(document.createNode('vase').setMesh(mesh));
  return new NodeIO().writeBinary(document);
}
