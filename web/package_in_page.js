// SPDX-License-Identifier: MIT
// Build step: leaves out the parts of the package and of three.js that the page does not need,
// shortens shaders, and preloads WebAssembly.

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

/** Modules that the page's workers never need: the page writes nothing compressed, and asks for the
 * whole engine before anything else, which then takes arrays, too. */
const unneeded = /\/(codecs\/compress|arrays_script)\.js$/;
const unneededNames = 'compressed = null, requireCompressible = null, createInstance = null';

/** @returns {import('vite').Plugin} for the page's workers */
export function withoutUnneeded() {
  return {
    name: 'without-unneeded',
    enforce: 'pre',
    resolveId: (source) => (unneeded.test(source) ? nothing : null),
    load: (id) => (id === nothing ? `export const ${unneededNames};` : null),
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

/** A shader of three.js: a string on a line of its own, or a marked template. */
const shader = /^(?:var|const) [\w$]+ = "#?.*\\n.*";$|\/\* glsl \*\/`[^`]*`/gm;
/** In a shader: comments, ends of lines, and what follows these and can go. */
const comment = /\/\/.*?(?=\\n|\n)/g, blank = /(?:(?:\\n|\n)(?:\\t|\s)*)+/g;

/** @returns {import('vite').Plugin} for the page: shaders without comments and indentation */
export function shortShaders() {
  return {
    name: 'short-shaders',
    transform: (code, id) => (/\/three\/.*\.js$/.test(id)
      ? { code: code.replace(shader, (text) => text.replace('/* glsl */', '')
        .replaceAll(comment, '').replaceAll(blank, '\\n')), map: null } : null),
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
