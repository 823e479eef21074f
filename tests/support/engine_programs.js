// SPDX-License-Identifier: MIT
// Programs by the entries that they import. `uses`: the ways to run a program, each with the
// engines that the package then loads, in order; `laid`: the engines that a bundler puts beside its
// script.

const mesh = `const mesh = {
  positions: new Float32Array([1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1]),
  indices: new Uint16Array([0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5,
    0, 3, 5]),
};
const options = { vertices: 30, quality: 'draft' };
`;

/** @type {Record<string, { laid: string[], uses: Record<string, string[]>, program: string }>} */
export const programs = {
  main: {
    laid: ['arrays', 'whole'],
    uses: { mesh: ['arrays'], scene: ['arrays'], look: ['arrays'], file: ['whole'],
      convert: ['whole'], both: ['arrays', 'whole'], fileFirst: ['whole'], warm: ['whole'],
      warmArrays: ['arrays'], pool: ['arrays'], poolOfFiles: ['whole'], here: ['arrays'] },
    program: `import {
  convertFile, init, inspect, remesh, remeshFile, remeshScene,
} from 'remesher';
import { Pool } from 'remesher/pool';
${mesh}const bytes = new TextEncoder().encode(
  'OFF\\n4 4 0\\n0 0 0\\n1 0 0\\n0 1 0\\n0 0 1\\n3 0 2 1\\n3 0 1 3\\n3 1 2 3\\n3 2 0 3\\n');
const named = { name: 'a.off', output: 'a.obj' };
const file = () => remeshFile(bytes, { ...named, ...options });
async function inPool(run) {
  const pool = new Pool({ size: 2 });
  await Promise.all([run(pool), run(pool)]);
  pool.close();
}
const uses = {
  mesh: () => remesh(mesh, options),
  scene: () => remeshScene([{ mesh }], options),
  look: () => inspect(mesh),
  file,
  convert: () => convertFile(bytes, named),
  both: () => Promise.all([remesh(mesh, options), file(), remesh(mesh, options)]),
  fileFirst: () => inspect(bytes, { name: 'a.off' }).then(() => remesh(mesh, options)),
  warm: () => init().then(() => remesh(mesh, options)),
  warmArrays: () => init({ arrays: {} }).then(() => remesh(mesh, options)),
  pool: () => inPool((pool) => pool.remesh(mesh, options)),
  poolOfFiles: () => inPool((pool) => pool.inspect(bytes, { name: 'a.off' })),
  here: () => remesh(mesh, { ...options, worker: false }),
};
`,
  },
  arrays: {
    laid: ['arrays'],
    uses: { mesh: ['arrays'], scene: ['arrays'], look: ['arrays'], warm: ['arrays'],
      here: ['arrays'] },
    program: `import { init, inspect, remesh, remeshScene } from 'remesher/arrays';
${mesh}const uses = {
  mesh: () => remesh(mesh, options),
  scene: () => remeshScene([{ mesh }], options),
  look: () => inspect(mesh),
  warm: () => init(),
  here: () => remesh(mesh, { ...options, worker: false }),
};
`,
  },
  three: {
    laid: ['arrays'],
    uses: { geometry: ['arrays'], object: ['arrays'] },
    program: `import { Mesh, TorusGeometry } from 'three';
import { remeshGeometry, remeshObject } from 'remesher/three';
const torus = new TorusGeometry(1, 0.4, 12, 24);
const uses = {
  geometry: () => remeshGeometry(torus, { vertices: 90 }),
  object: () => remeshObject(new Mesh(torus), { vertices: 90 }),
};
`,
  },
  gltf_transform: {
    laid: ['arrays'],
    uses: { document: ['arrays'] },
    program: `import { Document, Logger } from '@gltf-transform/core';
import { remesh } from 'remesher/gltf-transform';
${mesh}const document = new Document().setLogger(new Logger(Logger.Verbosity.SILENT));
const accessor = (type, array) => document.createAccessor().setType(type).setArray(array)
  .setBuffer(document.getRoot().listBuffers()[0] ?? document.createBuffer());
const primitive = document.createPrimitive().setIndices(accessor('SCALAR', mesh.indices))
  .setAttribute('POSITION', accessor('VEC3', mesh.positions));
document.createScene().addChild(
  document.createNode().setMesh(document.createMesh().addPrimitive(primitive)));
const uses = { document: () => document.transform(remesh(options)) };
`,
  },
};
