// SPDX-License-Identifier: MIT
// Assembles the npm package in dist/: our sources unchanged, the WebAssembly, the decoders of
// compressed glTF, and the types read from the comments.
import {
  chmodSync, copyFileSync, cpSync, existsSync, readdirSync, readFileSync, rmSync, writeFileSync,
} from 'node:fs';
import { basename, join, relative } from 'node:path';
import { gzipSync } from 'node:zlib';

import { optionDeclarations, withPlainImports, withPlainTypes } from './declarations.js';
import { root, run, say } from './say.js';
import { Stamp } from './stamp.js';

/** Minifies code that nobody reads in the package, without comments. @param {string} text */
async function shortened(text) {
  const { transform } = await import('esbuild'); // one of the npm packages that the build installs
  return (await transform(text, { minify: true, format: 'esm', target: 'es2022' })).code;
}

/**
 * Our modules around the codecs of compressed glTF. The modules import nothing: they work with
 * any bundler and without one, and a user of the package installs nothing else.
 * @returns {Promise<Record<string, string>>} contents by file name
 */
async function decoderModules() {
  const read = (/** @type {string} */ file) => readFileSync(join(root, 'node_modules', file));
  const { build } = await import('esbuild');
  const zip = await build({
    stdin: { contents: "export { strToU8, unzipSync, zipSync } from 'fflate';", resolveDir: root },
    bundle: true, minify: true, format: 'esm', target: 'es2022', platform: 'browser', write: false,
    legalComments: 'none',
  });
  // Without `process` the script does not assume Node. Without the names of CommonJS no bundler
  // takes the script for a mixture of both kinds of module, or looks for Node's modules.
  const draco = '// Draco, https://github.com/google/draco, Apache-2.0\n';
  return {
    'meshopt_decoder.mjs': `// meshoptimizer, https://github.com/zeux/meshoptimizer, MIT,
// Copyright (C) 2016-2026, by Arseny Kapoulkine
${await shortened(String(read('meshoptimizer/meshopt_decoder.mjs')))}`,
    'zip.mjs': `// fflate, https://github.com/101arrowz/fflate, MIT, Copyright (c) 2023 Arjun Barrett
${zip.outputFiles[0].text}`,
    'meshopt_encoder.mjs': `// meshoptimizer, https://github.com/zeux/meshoptimizer, MIT,
// Copyright (C) 2016-2026, by Arseny Kapoulkine
${await shortened(String(read('meshoptimizer/meshopt_encoder.js')))}`,
    'draco_decoder.mjs': draco + await selfContained('DracoDecoderModule',
      'draco3dgltf/draco_decoder_gltf_nodejs.js', 'draco3dgltf/draco_decoder_gltf.wasm'),
    'draco_encoder.mjs': draco + await selfContained('DracoEncoderModule',
      'draco3dgltf/draco_encoder_gltf_nodejs.js', 'draco3dgltf/draco_encoder.wasm'),
    'basis_decoder.mjs': `// Basis Universal, https://github.com/BinomialLLC/basis_universal, \
Apache-2.0
${await selfContained('BASIS', 'three/examples/jsm/libs/basis/basis_transcoder.js',
    'three/examples/jsm/libs/basis/basis_transcoder.wasm')}`,
  };
}

/**
 * A script that Emscripten made, as a module with its WebAssembly inside.
 * @param {string} name of the function that it defines @param {string} script @param {string} wasm
 */
async function selfContained(name, script, wasm) {
  const read = (/** @type {string} */ file) => readFileSync(join(root, 'node_modules', file));
  return `${await shortened(`const ${name} = (function () {
const process = undefined, module = undefined, exports = undefined, require = undefined;
${read(script)}
return ${name};
})();
const packed = '${gzipSync(read(wasm), { level: 9 }).toString('base64')}';
export default async (options) => {
  const bytes = Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0));
  const unpacked = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  return ${name}({ ...options, wasmBinary: await new Response(unpacked).arrayBuffer() });
};
`)}`;
}

/** @param {string} folder @returns {string[]} the files below it, by their paths from the root */
function filesIn(folder) {
  return readdirSync(join(root, folder), { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => relative(root, join(entry.parentPath ?? entry.path, entry.name)))
    .sort();
}

async function emitDeclarations() {
  writeFileSync(join(root, 'dist/base/remesh_options.d.ts'), optionDeclarations());
  await run(process.execPath,
    ['node_modules/typescript-7/bin/tsc', '-p', 'bindings/tsconfig.json']);
  for (const file of filesIn('dist').filter((name) => name.endsWith('.d.ts'))) {
    const path = join(root, file);
    writeFileSync(path, withPlainTypes(withPlainImports(readFileSync(path, 'utf8'))));
  }
}

/** The whole engine, and the engine for arrays only. */
const engines = ['remesher', 'remesher_arrays'];

/** @param {string} engine */
const filesOf = (engine) => [`build/wasm/${engine}.mjs`, `build/wasm/${engine}.wasm`];

/**
 * Removes the address of the WebAssembly, because the script gets the module compiled. With the
 * address, bundlers would copy the file beside every program that might run the script.
 * @param {string} script
 */
const withoutAddress = (script) =>
  script.replace(/new URL\((["']\w+\.wasm["']), *import\.meta\.url\)\.(toString\(\)|href)/g, '$1');

/** @param {string} engine */
async function layEngine(engine) {
  const [script, wasm] = filesOf(engine);
  const text = await shortened(withoutAddress(readFileSync(join(root, script), 'utf8')));
  writeFileSync(join(root, 'dist', basename(script)), text);
  copyFileSync(join(root, wasm), join(root, 'dist', basename(wasm)));
  chmodSync(join(root, 'dist', basename(wasm)), 0o644);
}

export async function assemblePackage() {
  const sources = filesIn('bindings/package');
  const declarations = readdirSync(join(root, 'bindings'))
    .filter((file) => /\.d\.m?ts$/.test(file)).map((file) => `bindings/${file}`);
  const inputs = [...sources, ...engines.flatMap(filesOf),
    ...declarations, 'bindings/build/assemble.js', 'bindings/build/declarations.js',
    'bindings/tsconfig.json', 'package.json', 'package-lock.json'];
  const stamp = new Stamp('build/dist.stamp', inputs);
  if (stamp.isCurrent() && existsSync(join(root, 'dist/index.d.ts'))) return;
  say('Assembling the package in dist/');
  rmSync(join(root, 'dist'), { recursive: true, force: true });
  cpSync(join(root, 'bindings/package'), join(root, 'dist'), { recursive: true });
  for (const file of declarations) {
    copyFileSync(join(root, file), join(root, 'dist', basename(file)));
  }
  for (const [name, text] of Object.entries(await decoderModules())) {
    writeFileSync(join(root, 'dist', name), text);
  }
  for (const engine of engines) await layEngine(engine);
  chmodSync(join(root, 'dist/cli/cli.js'), 0o755);
  await emitDeclarations();
  stamp.set();
}

/** Makes build/profile/package: dist/ with an engine for arrays that keeps its function names. */
export function assembleProfile() {
  cpSync(join(root, 'dist'), join(root, 'build/profile/package'), { recursive: true });
  for (const file of ['remesher_arrays.mjs', 'remesher_arrays.wasm']) {
    copyFileSync(join(root, 'build/profile', file), join(root, 'build/profile/package', file));
  }
}
