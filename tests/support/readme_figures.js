// SPDX-License-Identifier: MIT
// The README's figures, as runs give them today: node tests/support/readme_figures.js prints them.
import { createRequire } from 'node:module';

import { remesh, repair } from 'remesher';

import { overlappingBoxes } from './broken_shapes.js';

const require = createRequire(import.meta.url);

/** The Stanford bunny of the npm package. */
function bunny() {
  const { positions, cells } = require('bunny');
  return { positions: new Float64Array(positions.flat()), indices: new Uint32Array(cells.flat()) };
}

/** @returns {Promise<string[]>} what the README says, in its words */
export async function figuresOfReadme() {
  const mesh = bunny();
  const { report: { input, output } } = await remesh(mesh);
  const best = ({ minAngle }) => Math.round(minAngle.histogram[5]);
  const united = await repair(overlappingBoxes());
  const { report: { output: { quads } } } = await remesh(mesh, { quads: true, vertices: 3000 });
  return [
    `${best(output)} % of a bunny's ${input.triangles.toLocaleString('en')} triangles`,
    `; ${best(input)} % had`,
    `a bunny in ${quads.count.toLocaleString('en')} quads`,
    `has ${quads.irregular} irregular vertices`,
    `become one closed body of ${united.report.output.triangles} triangles`,
  ];
}

if (import.meta.filename === process.argv[1]) console.log((await figuresOfReadme()).join('\n'));
