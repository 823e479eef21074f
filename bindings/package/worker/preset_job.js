// SPDX-License-Identifier: MIT
// What a preset comes to for a job: whether its baking and its compression serve the file.

import { isGltf } from '../base/contents.js';
import { withoutPresetBaking, withoutPresetCompression } from '../base/presets.js';

/** @typedef {import('../base/messages.js').Job} Job */
/** @typedef {Extract<Job, { kind: 'remeshFile' | 'repairFile' }>} FileJob */

export const namesGltf = (/** @type {string} */ name) => /\.gl(b|tf)$/i.test(name);

/** Whether there can be materials to bake from, and a file that holds what is baked.
 * @param {Job} job */
const canBake = (job) => job.kind === 'remeshFile' && namesGltf(job.file.output)
  && (isGltf(job.file.bytes) || job.file.resources.some(({ name }) => /\.mtl$/i.test(name)));

/** The job without the baking that a preset stands for, if nothing can be baked or new textures
 * would be worse than the model's own, and without compression if the file came without.
 * @param {Job} given @param {string | undefined} compress @returns {Promise<Job>} */
export async function withPresetSettled(given, compress) {
  if (!('options' in given) || !given.options.preset) return given;
  const job = compress ? given
    : /** @type {typeof given} */ ({ ...given, options: withoutPresetCompression(given.options) });
  if (canBake(job)) {
    const { bytes } = /** @type {FileJob} */ (job).file;
    const { isFileWorthBaking } = await import('../codecs/given_gltf.js');
    if (!isGltf(bytes) || isFileWorthBaking(bytes, Number(job.options.faces ?? 0))) return job;
  }
  return { ...job, options: withoutPresetBaking(job.options) };
}

/** The job without the baking that a preset stands for, if its outcome has shown that it added
 * nothing; undefined if it did. @param {Job} job as it was run @param {any} outcome
 * @returns {Promise<Job | undefined>} */
export async function withoutVainBaking(job, { report }) {
  if (job.kind !== 'remeshFile' || !isGltf(job.file.bytes)) return undefined;
  const options = withoutPresetBaking(job.options);
  if (options === job.options) return undefined;
  const { wasFileBakedInVain } = await import('../codecs/given_gltf.js');
  return wasFileBakedInVain(job.file.bytes, report.fidelity) ? { ...job, options } : undefined;
}

/** Whether the images that a result keeps may become WebP: a preset has chosen it for new ones.
 * @param {Job} given @param {Job} settled as it was run */
export function makesImagesLighter(given, settled) {
  return 'options' in given && 'options' in settled && settled.options.textures !== 'bake'
    && Object(given.options.preset).textureFormat === 'webp';
}

/** How the result's glTF is to be compressed: as it came, if that was asked for.
 * @param {Job} job as it was given @returns {Promise<'meshopt' | 'draco' | undefined>} */
export async function compressionOf(job) {
  const asked = 'options' in job ? job.options?.compress : undefined;
  if (asked !== 'auto') return /** @type {'meshopt' | 'draco' | undefined} */ (asked);
  if (!('file' in job) || !namesGltf(job.file.output) || !isGltf(job.file.bytes)) return undefined;
  return (await import('../codecs/given_gltf.js')).compressionIn(job.file.bytes);
}
