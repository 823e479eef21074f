// SPDX-License-Identifier: MIT
// Build step: leaves out what the page and its workers do not need, of the package and of three.js,
// and preloads WebAssembly.

const nothing = '\0nothing';
const exported = 'export const Engine = null, plainWorker = null, loadPackage = () => {};';

/** Modules that the page never uses. Its browsers have workers, and its worker has codecs, so that
 * no engine runs in the page itself and no plain worker starts. */
const unused = /\/(worker\/engine|plain_worker|textures\/bundled_packages)\.js$/;

/** @returns {import('vite').Plugin} for the page, not for its workers */
export function withoutUnused() {
  return {
    name: 'without-unused',
    enforce: 'pre',
    resolveId: (source) => (unused.test(source) ? nothing : null),
    load: (id) => (id === nothing ? exported : null),
  };
}

/** @returns {import('vite').Plugin} for the page's workers: what it writes is not compressed */
export function withoutCompression() {
  return {
    name: 'without-compression',
    enforce: 'pre',
    resolveId: (source) => (/\/codecs\/compress\.js$/.test(source) ? nothing : null),
    load: (id) => (id === nothing ? 'export const compressed = null, requireCompressible = null;'
      : null),
  };
}

/** Statements of three.js that set properties of classes: with them a class stays that nobody
 * makes. */
const statics = /^(?:PropertyBinding|\w*KeyframeTrack)(?:\.\w+)+ = [^;]*;/gm;

/** @returns {import('vite').Plugin} for the page's workers, which measure surfaces and animate
 *   nothing */
export function withoutAnimations() {
  return {
    name: 'without-animations',
    transform: (code, id) => (/\/three\.core\.js$/.test(id)
      ? { code: code.replace(statics, ''), map: null } : null),
  };
}

/** The WebAssembly begins to load before any script has run.
 * @returns {import('vite').Plugin} for the page */
export function earlyWasm() {
  return {
    name: 'early-wasm',
    transformIndexHtml: {
      order: 'post',
      handler(_html, { bundle = {} }) {
        const file = Object.keys(bundle).find((name) => /remesher-[\w-]+\.wasm$/.test(name));
        return file ? [{ tag: 'link', injectTo: 'head', attrs: { rel: 'preload', as: 'fetch',
          type: 'application/wasm', crossorigin: true, href: `./${file}` } }] : [];
      },
    },
  };
}
