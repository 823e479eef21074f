// SPDX-License-Identifier: MIT
// One large input through one program, in a process of its own: prints the processor's seconds,
// the peak of the process, and what came of it, as JSON.
//   node tests/bench/large_one.js INPUT TRIANGLES VERTICES remesher|meshoptimizer|none
import { MeshoptSimplifier } from 'meshoptimizer';
import { remesh } from 'remesher';

import * as inputs from './large_inputs.js';
import { ownClock } from './yardstick.js';

const programs = {
  async remesher(mesh, vertices) {
    const { report } = await remesh(mesh, { vertices, worker: false });
    return { vertices: report.output.vertices, boundary: report.output.boundaryEdges > 0,
      hausdorff: report.fidelity.hausdorff, bytes: report.memory.peakBytes };
  },
  async meshoptimizer({ positions, indices }, vertices) {
    await MeshoptSimplifier.ready;
    const [kept] = MeshoptSimplifier.simplify(indices, positions, 3, 6 * vertices, 1);
    return { vertices: new Set(kept).size };
  },
  none: async () => ({}),
};

const [input, triangles, vertices, program] = process.argv.slice(2);
const mesh = inputs[input](Number(triangles));
const start = ownClock();
const outcome = await programs[program](mesh, Number(vertices))
  .catch((error) => ({ code: error.code ?? 'INTERNAL', message: error.message }));
console.log(JSON.stringify({ ...outcome, triangles: mesh.indices.length / 3,
  seconds: (ownClock() - start) / 1000, peak: 1024 * process.resourceUsage().maxRSS }));
