// SPDX-License-Identifier: MIT
// Build step: writes the built-in models, which npm packages carry as JavaScript arrays, as OBJ
// files into the built page.
import { createRequire } from 'node:module';
import { samples } from './model/samples.js';

const require = createRequire(import.meta.url);

/** The package that holds each sample. */
const sources = /** @type {Record<string, string>} */ ({
  bunny: 'bunny',
  teapot: 'teapot',
});

/** @param {{ positions: number[][], cells: number[][] }} mesh */
function toObj({ positions, cells }) {
  const vertices = positions.map((p) => `v ${p.join(' ')}`);
  const faces = cells.map((cell) => `f ${cell.map((index) => index + 1).join(' ')}`);
  return [...vertices, ...faces, ''].join('\n');
}

/** @returns {import('vite').Plugin} */
export function sampleFiles() {
  return {
    name: 'sample-files',
    generateBundle() {
      for (const { id, file } of samples) {
        const source = toObj(require(sources[id]));
        this.emitFile({ type: 'asset', fileName: `samples/${file}`, source });
      }
    },
  };
}
