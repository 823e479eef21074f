// SPDX-License-Identifier: MIT
// A program that imports from every entry of the package and remeshes. It runs in Node and in the
// pages that bundlers make, and prints one line.

const octahedron = `{
  positions: new Float32Array([1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1]),
  indices: new Uint16Array([0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5,
    0, 3, 5]),
}`;

/** The names that the program imports, by module. */
const taken = {
  remesher: ['remesh', 'RemeshError'],
  'remesher/arrays': ['inspect'],
  'remesher/three': ['remeshGeometry'],
  'remesher/gltf-transform': ['remesh: transform'],
  'remesher/pool': ['Pool'],
  'remesher/options': ['optionTable'],
  'remesher/formats': ['formats'],
  'remesher/card': ['cardText'],
  'remesher/gunzip': ['gunzip'],
  'remesher/ktx2': ['decodeKtx2'],
  'remesher/codecs': ['codecs'],
  three: ['TorusGeometry'],
  '@gltf-transform/core': ['Document', 'Logger'],
};

/** The line that the program prints. */
export const expected = '30 8 90 25 40 true glb true true true true true';

/** The package's entries that the program imports. */
export const entries = Object.keys(taken).filter((name) => name.startsWith('remesher'));

const body = `
const mesh = ${octahedron};
const own = await remesh(mesh, { vertices: 30 });
const { input } = await inspect(mesh);
const { report } = await remeshGeometry(new TorusGeometry(1, 0.4, 12, 24), { vertices: 90 });
const document = new Document().setLogger(new Logger(Logger.Verbosity.SILENT));
const accessor = (type, array) => document.createAccessor().setType(type).setArray(array)
  .setBuffer(document.getRoot().listBuffers()[0] ?? document.createBuffer());
const primitive = document.createPrimitive().setIndices(accessor('SCALAR', mesh.indices))
  .setAttribute('POSITION', accessor('VEC3', mesh.positions));
document.createScene().addChild(
  document.createNode().setMesh(document.createMesh().addPrimitive(primitive)));
await document.transform(transform({ vertices: 25 }));
const written = document.getRoot().listMeshes()[0].listPrimitives()[0].getAttribute('POSITION');
const pool = new Pool({ size: 2 });
await pool.init({ wasmUrl });
const pooled = await pool.remesh(mesh, { vertices: 40 });
const failed = await pool.inspect({}).catch((error) => error instanceof RemeshError);
pool.close();
const line = [own.report.output.vertices, input.triangles, report.output.vertices,
  written.getCount(), pooled.report.output.vertices, optionTable.length > 10, formats[0], failed,
  typeof cardText === 'function',
  typeof gunzip === 'function', typeof decodeKtx2 === 'function',
  typeof codecs.worker === 'function'].join(' ');`;

/**
 * The program as an ES module that passes its line to `tell`; in Node that is `console.log`.
 * @param {string} wasm a statement that defines `wasmUrl`, the address of remesher.wasm
 * @param {string} tell a function's name
 */
export function moduleProgram(wasm, tell) {
  const imports = Object.entries(taken).map(([module, names]) =>
    `import { ${names.join(', ').replace(':', ' as')} } from '${module}';`);
  return [...imports, wasm, body, `${tell}(line);`, ''].join('\n');
}

/** The program as CommonJS. */
export function commonProgram() {
  const requires = Object.entries(taken).map(([module, names]) =>
    `const { ${names.join(', ')} } = require('${module}');`);
  const wasm = `const wasmUrl = require('node:url')
    .pathToFileURL(require.resolve('remesher/remesher.wasm'));`;
  return [...requires, '(async () => {', wasm, body, 'console.log(line);', '})();', '']
    .join('\n');
}
