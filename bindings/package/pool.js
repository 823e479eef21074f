// SPDX-License-Identifier: MIT
// remesher/pool in browsers, and its documentation for every platform. The
// `new URL(…, import.meta.url)` is written out so that bundlers see it.

import { PoolOf } from './api/pool_of.js';
import * as platform from './platform_browser.js';

/**
 * The types of the options.
 * @typedef {import('./api/pool_of.js').PoolOptions} PoolOptions
 */
/** @import * as Package from './index.js' */

const compileWhole = () => platform.compileUrl(new URL('./remesher.wasm', import.meta.url));

/**
 * Several workers with the package's functions. Each job goes to the first worker that is free;
 * workers start when they are needed, share compiled modules, and keep no program from ending
 * while they are idle.
 *
 * @example
 * const pool = new Pool({ size: 4 });
 * const results = await Promise.all(files.map((file) => pool.remeshFile(file, { ratio: 0.5 })));
 * pool.close();
 */
export class Pool {
  #pool;

  /** @param {PoolOptions} [options] How many workers there may be. */
  constructor(options = {}) {
    this.#pool = new PoolOf({ ...platform, compileWhole }, options);
  }

  /**
   * Loads an engine, as the package's function does, and starts all workers ahead of time.
   * Optional.
   *
   * @param {Package.InitOptions} [options] Where the WebAssembly is; where bundlers put it, if not
   *   given.
   * @returns {Promise<void>} Once the next runs can begin at once.
   */
  init(options) {
    return this.#pool.init(options);
  }

  /**
   * Remeshes a mesh, as the package's function does.
   *
   * @param {Package.Mesh} mesh The surface: positions, triangles, and what else the vertices have.
   * @param {Package.RemeshOptions & Package.RunOptions} [options] What to make of it, and how to
   *   run.
   * @returns {Promise<Package.RemeshResult>} The new mesh and a report. Rejects with a
   *   `RemeshError`.
   */
  remesh(mesh, options) {
    return this.#pool.remesh(mesh, options);
  }

  /**
   * Remeshes the meshes of a scene, as the package's function does: in one worker.
   *
   * @param {Package.PlacedMesh[]} parts The meshes, and where they are shown.
   * @param {Package.RemeshOptions & Package.RunOptions} [options] What to make of them, and how to
   *   run.
   * @returns {Promise<Package.RemeshSceneResult>} The new meshes and one report. Rejects with a
   *   `RemeshError`.
   */
  remeshScene(parts, options) {
    return this.#pool.remeshScene(parts, options);
  }

  /**
   * Remeshes a file, as the package's function does.
   *
   * @param {Package.Bytes} bytes The file.
   * @param {Package.RemeshOptions & Package.FileOptions & Package.OutputOptions
   *   & Package.RunOptions} [options] What to make of it, its name, the result's name, and how to
   *   run.
   * @returns {Promise<Package.RemeshFileResult>} The new file and a report. Rejects with a
   *   `RemeshError`.
   */
  remeshFile(bytes, options) {
    return this.#pool.remeshFile(bytes, options);
  }

  /**
   * Mends a mesh, as the package's function does.
   *
   * @param {Package.Mesh} mesh The surface.
   * @param {Package.RepairOptions & Package.RunOptions} [options] How to mend it, and how to run.
   * @returns {Promise<Package.RepairResult>} The mended mesh and a report. Rejects with a
   *   `RemeshError`.
   */
  repair(mesh, options) {
    return this.#pool.repair(mesh, options);
  }

  /**
   * Mends a file, as the package's function does.
   *
   * @param {Package.Bytes} bytes The file.
   * @param {Package.RepairOptions & Package.FileOptions & Package.OutputOptions
   *   & Package.RunOptions} [options] How to mend it, its name, the result's name, and how to run.
   * @returns {Promise<Package.RepairFileResult>} The mended file and a report. Rejects with a
   *   `RemeshError`.
   */
  repairFile(bytes, options) {
    return this.#pool.repairFile(bytes, options);
  }

  /**
   * The union, difference or intersection of two bodies, as the package's function makes it.
   *
   * @param {Package.Mesh} a The first mesh.
   * @param {Package.Mesh} b The second mesh.
   * @param {Package.BooleanOperation} operation What to make of them.
   * @param {Package.RunOptions} [options] How to run.
   * @returns {Promise<Package.BooleanResult>} The new mesh and a report. Rejects with a
   *   `RemeshError`.
   */
  boolean(a, b, operation, options) {
    return this.#pool.boolean(a, b, operation, options);
  }

  /**
   * The union, difference or intersection of two files, as the package's function makes it.
   *
   * @param {Package.Bytes} a The first file.
   * @param {Package.Bytes} b The second file.
   * @param {Package.BooleanOperation} operation What to make of them.
   * @param {Package.OperandOptions & Package.OutputOptions & Package.RunOptions} [options] The
   *   files' names, the result's name, and how to run.
   * @returns {Promise<Package.BooleanFilesResult>} The new file and a report. Rejects with a
   *   `RemeshError`.
   */
  booleanFiles(a, b, operation, options) {
    return this.#pool.booleanFiles(a, b, operation, options);
  }

  /**
   * Paints one mesh onto another, as the package's function does.
   *
   * @param {Package.Mesh} high The mesh to paint from.
   * @param {Package.Mesh} low The mesh to paint onto.
   * @param {Package.BakeOptions & Package.RunOptions} [options] How to paint, and how to run.
   * @returns {Promise<Package.BakeResult>} The low mesh with texture coordinates, and its maps.
   *   Rejects with a `RemeshError`.
   */
  bake(high, low, options) {
    return this.#pool.bake(high, low, options);
  }

  /**
   * Paints one file onto another, as the package's function does.
   *
   * @param {Package.Bytes} high The file to paint from.
   * @param {Package.Bytes} low The file to paint onto.
   * @param {Package.BakeOptions & Package.BakeFileOptions & Package.OutputOptions
   *   & Package.RunOptions} [options] How to paint, the files' names, the result's name, and how to
   *   run.
   * @returns {Promise<Package.AtlasFileResult>} The new file and a report. Rejects with a
   *   `RemeshError`.
   */
  bakeFile(high, low, options) {
    return this.#pool.bakeFile(high, low, options);
  }

  /**
   * Gives a mesh new texture coordinates, as the package's function does.
   *
   * @param {Package.Mesh} mesh The surface.
   * @param {Package.UnwrapOptions & Package.RunOptions} [options] The size of the square, and how
   *   to run.
   * @returns {Promise<Package.UnwrapResult>} The mesh and a report. Rejects with a `RemeshError`.
   */
  unwrap(mesh, options) {
    return this.#pool.unwrap(mesh, options);
  }

  /**
   * Gives a file new texture coordinates, as the package's function does.
   *
   * @param {Package.Bytes} bytes The file.
   * @param {Package.UnwrapOptions & Package.FileOptions & Package.OutputOptions
   *   & Package.RunOptions} [options] The size of the square, the file's name, the result's name,
   *   and how to run.
   * @returns {Promise<Package.AtlasFileResult>} The new file and a report. Rejects with a
   *   `RemeshError`.
   */
  unwrapFile(bytes, options) {
    return this.#pool.unwrapFile(bytes, options);
  }

  /**
   * Writes a file in another format, as the package's function does.
   *
   * @param {Package.Bytes} bytes The file.
   * @param {Package.ConvertOptions & Package.FileOptions & Package.OutputOptions
   *   & Package.RunOptions} [options] How to compress it, its name, the result's name, and how to
   *   run.
   * @returns {Promise<Package.ConvertFileResult>} The new file. Rejects with a `RemeshError`.
   */
  convertFile(bytes, options) {
    return this.#pool.convertFile(bytes, options);
  }

  /**
   * Reports on a file or a mesh, as the package's function does.
   *
   * @param {Package.Bytes | Package.Mesh} bytesOrMesh The file, or the mesh.
   * @param {Package.InspectOptions & Package.FileOptions & Package.RunOptions} [options] Whether to
   *   look for faults, the file's name, and how to run.
   * @returns {Promise<Package.Inspection>} What there is. Rejects with a `RemeshError`.
   */
  inspect(bytesOrMesh, options) {
    return this.#pool.inspect(bytesOrMesh, options);
  }

  /**
   * Ends the workers. Jobs that run or wait, and later ones, reject with an `AbortError`. Cheap to
   * repeat.
   */
  close() {
    this.#pool.close();
  }
}
