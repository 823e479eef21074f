// SPDX-License-Identifier: MIT
// How the page becomes a folder of static files, in build/web: relative addresses, so that any
// server and any path will do.
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { sampleFiles } from './sample_files.js';
import { wordsInPlace } from './words_in_place.js';

export default defineConfig({
  root: fileURLToPath(new URL('.', import.meta.url)),
  base: './',
  publicDir: false,
  plugins: [sampleFiles(), wordsInPlace()],
  worker: { format: 'es' },
  build: {
    outDir: fileURLToPath(new URL('../build/web', import.meta.url)),
    emptyOutDir: true,
    target: 'es2022',
    modulePreload: { polyfill: false },
    chunkSizeWarningLimit: 2000,
  },
});
