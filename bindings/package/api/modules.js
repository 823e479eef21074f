// SPDX-License-Identifier: MIT
// The two engines, the small one for arrays and the whole one, as compiled modules of one client or
// of all clients of a pool. Each is compiled when it is first needed. Once the whole one is there
// it serves arrays too: nobody holds both.

import { RemeshError } from '../base/errors.js';

/** @import { EngineName, Job, Loaded } from '../base/messages.js' */

/** @typedef {() => Promise<WebAssembly.Module>} Compile */

/** Options that only the whole engine can keep. */
const limits = ['minEdge', 'maxEdge', 'minAngle', 'region'];

/** @param {Job} job @returns {EngineName} the least that can run it */
export function neededBy(job) {
  if (job.kind === 'inspect') return job.closely ? 'whole' : 'arrays';
  if (job.kind !== 'remesh') return 'whole';
  const { repair = 'off', quads, dropBelow, dropHidden, lods, conform } = job.options;
  const isLimited = limits.some((name) => job.options[name] !== undefined);
  const isByPixels = typeof Object(lods)[0] === 'string';
  const isPlain = repair === 'off' && !quads && dropBelow === undefined && !dropHidden
    && !conform && !isByPixels && !isLimited;
  return isPlain ? 'arrays' : 'whole';
}

/** Only the whole engine thins out meshes of more triangles than these before anything is built of
 * them; src/jobs/thinned_parts.h has the same number. */
export const thinnedAbove = 1_500_000;

/** Whether a job that the small engine can run had better be the whole one's. @param {Job} job */
const isHuge = (job) => job.kind === 'remesh'
  && job.parts.some(({ mesh }) => mesh.indices.length > 3 * thinnedAbove);

const wholeIsMissing = () => new RemeshError('UNSUPPORTED',
  'Repair, quads, regions, common faces, limits of every edge and levels by pixels are not in the '
    + 'engine for arrays.',
  "Import 'remesher', beside an adapter or instead of 'remesher/arrays'.");

export class Modules {
  /** @type {Partial<Record<EngineName, Compile>>} */
  #sources = {};
  /** @type {Partial<Record<EngineName, Promise<WebAssembly.Module>>>} */
  #loading = {};

  /** @param {Compile} compileArrays */
  constructor(compileArrays) {
    this.#sources.arrays = compileArrays;
  }

  /** The engine for a job. @param {Job} job @returns {EngineName} */
  engineFor(job) {
    const isWhole = isHuge(job) && this.#sources.whole !== undefined;
    return isWhole ? 'whole' : neededBy(job);
  }

  /** Sets where an engine comes from, if nobody says otherwise. @param {EngineName} engine
   * @param {Compile} compile */
  offer(engine, compile) {
    this.#sources[engine] = compile;
  }

  /**
   * The engine for jobs that need this one. The first call says where a module comes from; a failed
   * call may be repeated. If the small engine is not to be had, as beside scripts that were bundled
   * before it existed, the whole one does its work.
   * @param {EngineName} needed
   * @param {Compile} [compile]
   * @returns {Promise<Loaded>}
   */
  async load(needed, compile) {
    const engine = this.#loading.whole ? 'whole' : needed;
    try {
      return { engine, module: await this.#compiled(engine, compile) };
    } catch (error) {
      if (engine === 'whole' || compile || !this.#sources.whole) throw error;
      return this.load('whole');
    }
  }

  /** @param {EngineName} engine @param {Compile | undefined} compile */
  #compiled(engine, compile = this.#sources[engine]) {
    const known = this.#loading[engine];
    if (known) return known;
    if (!compile) throw wholeIsMissing();
    const loading = compile();
    this.#loading[engine] = loading;
    loading.then(
      () => engine === 'whole' && delete this.#loading.arrays,
      () => delete this.#loading[engine]);
    return loading;
  }
}
