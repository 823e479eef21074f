// SPDX-License-Identifier: MIT
// Build step: writes the built-in models into the built page. Two are JavaScript arrays in npm
// packages, in the public domain; our formulas make the others.
import { createRequire } from 'node:module';
import { samples } from './model/samples.js';
import { gear } from './samples/gear.js';
import { scan } from './samples/scan.js';
import { vase } from './samples/vase.js';

const require = createRequire(import.meta.url);

/** @param {import('./samples/gear.js').PolygonMesh} mesh */
function toObj({ positions, cells }) {
  const vertices = positions.map((p) => `v ${p.map((x) => Number(x.toPrecision(9))).join(' ')}`);
  const faces = cells.map((cell) => `f ${cell.map((index) => index + 1).join(' ')}`);
  return [...vertices, ...faces, ''].join('\n');
}

/** The maker of each sample. @type {Record<import('./model/samples.js').Sample['id'],
 *   () => string | Promise<Uint8Array>>} */
const sources = {
  bunny: () => toObj(require('bunny')),
  teapot: () => toObj(require('teapot')),
  gear: () => toObj(gear()),
  scan: () => toObj(scan()),
  vase,
};

/** @returns {import('vite').Plugin} */
export function sampleFiles() {
  return {
    name: 'sample-files',
    async generateBundle() {
      for (const { id, file } of samples) {
        const source = await sources[id]();
        this.emitFile({ type: 'asset', fileName: `samples/${file}`, source });
      }
    },
  };
}
