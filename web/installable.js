// SPDX-License-Identifier: MIT
// Build step: makes the page an application that can be installed and works offline. All its
// addresses are relative, so that it can lie in any folder.
import { join } from 'node:path';
import { injectManifest } from '@serwist/build';
import en from './texts/en.js';

const icon = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 64 64">
<rect width="64" height="64" rx="14" fill="#0f766e"/>
<path fill="#fff" d="M32 12l20 37H12z"/>
<path fill="none" stroke="#0f766e" stroke-width="3" d="M22 30.500h20L32 49z"/>
</svg>
`;

const manifest = {
  name: 'remesher', short_name: 'remesher', description: en.tagline, lang: 'en',
  start_url: './', scope: './', display: 'standalone',
  background_color: '#ffffff', theme_color: '#0f766e',
  icons: [{ src: 'icon.svg', sizes: 'any', type: 'image/svg+xml', purpose: 'any' }],
};

/** @returns {import('vite').Plugin} */
export function installable() {
  let outDir = '';
  return {
    name: 'installable',
    configResolved: ({ build }) => { outDir = build.outDir; },
    generateBundle() {
      const source = `${JSON.stringify(manifest, null, 2)}\n`;
      this.emitFile({ type: 'asset', fileName: 'app.webmanifest', source });
      this.emitFile({ type: 'asset', fileName: 'icon.svg', source: icon });
    },
    transformIndexHtml: {
      order: 'post',
      handler: () => [{ tag: 'link', injectTo: 'head',
        attrs: { rel: 'manifest', href: './app.webmanifest' } }],
    },
    async writeBundle() {
      const worker = join(outDir, 'offline.js');
      const { warnings } = await injectManifest({
        swSrc: worker, swDest: worker, globDirectory: outDir,
        globPatterns: ['**/*.{html,js,css,wasm,woff2,obj,glb,svg,webmanifest}'],
        // The page takes files only and compresses none: it never loads what these are for.
        globIgnores: ['offline.js',
          '**/{remesher_arrays,draco_encoder,meshopt_encoder,compress}-*'],
        maximumFileSizeToCacheInBytes: 2 ** 24,
        dontCacheBustURLsMatching: /^assets\//,
      });
      if (warnings.length) throw new Error(warnings.join(' '));
    },
  };
}
