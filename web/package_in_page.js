// SPDX-License-Identifier: MIT
// Build step: what the page has of the package, otherwise than other users. Its worker has the
// codecs of images; the page itself runs nothing, for a browser that reads it has workers.
import { fileURLToPath } from 'node:url';

const codecs = fileURLToPath(new URL('image_codecs.js', import.meta.url));
const nothing = '\0nothing';

/** @returns {import('vite').Plugin} for the page */
export function withoutEngine() {
  return {
    name: 'without-engine',
    enforce: 'pre',
    resolveId: (source) => (source.endsWith('worker/engine.js') ? nothing : null),
    load: (id) => (id === nothing ? 'export const Engine = undefined;' : null),
  };
}

/** The WebAssembly is on its way before any script has run.
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

/** @returns {import('vite').Plugin} for the worker */
export function withCodecs() {
  return {
    name: 'with-codecs',
    enforce: 'pre',
    async resolveId(source, importer) {
      if (source === './codec_packages.js') return codecs;
      // Every browser that runs modules in workers has these instructions; two encoders might
      // differ in a byte.
      if (source !== './codec/enc/webp_enc.js') return null;
      return this.resolve('./codec/enc/webp_enc_simd.js', importer);
    },
  };
}
