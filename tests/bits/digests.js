// SPDX-License-Identifier: MIT
// In Node and in browsers alike: the digest of each job's result, or of how it failed.

/**
 * @param {typeof import('remesher')} remesher
 * @param {{ name: string, options: object }[]} jobs
 * @param {(name: string) => Promise<Uint8Array>} load
 */
export async function digestsOf(remesher, jobs, load) {
  const digests = [];
  for (const { name, options } of jobs) {
    const bytes = await load(name);
    const outcome = await remesher.remeshFile(bytes, { ...options, name, output: 'glb' })
      .then((result) => result.bytes, (error) => new TextEncoder().encode(String(error)));
    const hash = new Uint8Array(await crypto.subtle.digest('SHA-256', outcome));
    digests.push(Array.from(hash, (byte) => byte.toString(16).padStart(2, '0')).join(''));
  }
  return digests;
}
