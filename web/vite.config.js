// SPDX-License-Identifier: MIT
// Builds the page as a folder of static files, build/web. Its addresses are relative, so that any
// server and any path will do.
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { installable } from './installable.js';
import {
  earlyWasm, shortShaders, withoutAnimations, withoutUnneeded, withoutUnused,
} from './package_in_page.js';
import { sampleFiles } from './sample_files.js';
import { wordsInPlace } from './words_in_place.js';

export default defineConfig({
  root: fileURLToPath(new URL('.', import.meta.url)),
  base: './',
  publicDir: false,
  plugins: [sampleFiles(), wordsInPlace(), installable(), earlyWasm(), withoutUnused(),
    shortShaders()],
  // One script for all image codecs: they are much alike, and half as large if packed together.
  worker: { format: 'es', plugins: () => [withoutUnneeded(), withoutAnimations()],
    rolldownOptions: {
      output: { codeSplitting: { groups: [{ name: 'codecs', test: /@jsquash/ }] } } } },
  build: {
    outDir: fileURLToPath(new URL('../build/web', import.meta.url)),
    emptyOutDir: true,
    target: 'es2022',
    modulePreload: { polyfill: false },
    rolldownOptions: {
      input: { index: fileURLToPath(new URL('index.html', import.meta.url)),
        offline: fileURLToPath(new URL('offline.js', import.meta.url)) },
      // A service worker controls the folder it lies in, and its name must never change.
      output: { entryFileNames: ({ name }) =>
        (name === 'offline' ? 'offline.js' : 'assets/[name]-[hash].js') },
    },
    chunkSizeWarningLimit: 2000,
  },
});
