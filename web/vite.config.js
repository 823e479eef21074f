// SPDX-License-Identifier: MIT
// How the page becomes a folder of static files, in build/web: relative addresses, so that any
// server and any path will do.
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { installable } from './installable.js';
import { earlyWasm, withoutUnused } from './package_in_page.js';
import { sampleFiles } from './sample_files.js';
import { wordsInPlace } from './words_in_place.js';

export default defineConfig({
  root: fileURLToPath(new URL('.', import.meta.url)),
  base: './',
  publicDir: false,
  plugins: [sampleFiles(), wordsInPlace(), installable(), earlyWasm(), withoutUnused()],
  // The codecs of images in one script: they are much alike, and packed together half as large.
  worker: { format: 'es', rolldownOptions: {
    output: { codeSplitting: { groups: [{ name: 'codecs', test: /@jsquash/ }] } } } },
  build: {
    outDir: fileURLToPath(new URL('../build/web', import.meta.url)),
    emptyOutDir: true,
    target: 'es2022',
    modulePreload: { polyfill: false },
    rolldownOptions: {
      input: { index: fileURLToPath(new URL('index.html', import.meta.url)),
        offline: fileURLToPath(new URL('offline.js', import.meta.url)) },
      // A service worker speaks for the folder it lies in, and under one name for ever.
      output: { entryFileNames: ({ name }) =>
        (name === 'offline' ? 'offline.js' : 'assets/[name]-[hash].js') },
    },
    chunkSizeWarningLimit: 2000,
  },
});
