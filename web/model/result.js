// SPDX-License-Identifier: MIT
// A result: the one place that owns the mesh that is shown and saved. A run writes it once, in the
// model's own format if that holds all of it, else as glTF. The view and every other format are
// conversions of that file, so all have the same vertices and faces.
import { convertFile, remeshFile, repairFile } from 'remesher';
import { formats } from 'remesher/formats';
import { repairNames } from 'remesher/options';
import { extensionOf } from '../files/files.js';
import { openGlb } from '../files/glb.js';
import { lossesIn, trianglesOnly } from './losses.js';
import { nameFor } from './names.js';
import { isRepairOnly, optionsIn } from './purposes.js';

/** @typedef {import('../files/models.js').Model} Model */
/** @typedef {import('./address.js').Values} Values */
/** @typedef {import('remesher').RemeshOptions} RemeshOptions */
/** @typedef {import('remesher').ConvertOptions} ConvertOptions */
/** @typedef {import('./names.js').Report} Report */
/** @typedef {import('remesher').NamedBytes} NamedBytes */
/** @typedef {import('remesher').Warning} Warning */
/** @typedef {{ signal: AbortSignal,
 *   onProgress?: (event: import('remesher').ProgressEvent) => void }} Watch */
/** losses, warnings: parts of the result that the files lack.
 * @typedef {{ files: NamedBytes[], losses: import('./losses.js').Loss[],
 *   warnings: Warning[] }} Saved */

/** Formats besides glTF that hold faces of four corners, and more of a model than its surface:
 * names and material libraries, double precision, properties of vertices. */
const ownFormats = ['obj', 'off', 'ply'];

/** A PLY's header is a few lines, in ASCII. */
const longestHeader = 2 ** 16;

/** Whether a PLY has whole coordinates, to which the core rounds what it writes in its types.
 * @param {Uint8Array} bytes */
function isWhole(bytes) {
  const header = new TextDecoder('latin1').decode(bytes.subarray(0, longestHeader));
  return !/^\s*property\s+(?:float|double)\d*\s+x\s*$/m.test(header);
}

/** Whether a run may paint textures, as repairs of glTF do. Only a .gltf has them in files of their
 * own. @param {string} own the model's format @param {RemeshOptions} options */
const mayPaint = (own, { textures = 'auto', repair = 'off' }) => textures === 'bake'
  || (textures === 'auto' && repair !== 'off' && (own === 'glb' || own === 'gltf'));

/** The format in which a run writes its result.
 * @param {Model} model @param {RemeshOptions} options */
function formatOfRun({ name, bytes }, options) {
  const own = extensionOf(name);
  if (options.quality === 'draft') return 'glb';
  if (mayPaint(own, options)) return 'gltf';
  if (options.quads && trianglesOnly.includes(own)) return 'obj';
  const isRounded = own === 'ply' && isWhole(bytes);
  return ownFormats.includes(own) && !isRounded ? own : 'glb';
}

/** The part of every call's options that describes the file.
 * @param {Pick<Model, 'name' | 'resources'>} model */
export const describe = ({ name, resources }) => ({
  name, resources: Object.fromEntries(resources.map(({ name: key, bytes }) => [key, bytes])),
});

export class Result {
  /** The model's name. */
  #model;
  /** The files that the run wrote. @type {NamedBytes[]} */
  #written;
  /** Counts the results kept, from 1; 0 for a draft, which is not kept. */
  number = 0;
  /** The options as they were asked for in the form or the address. @type {Values} */
  values;
  /** All options of the run. @type {RemeshOptions} */
  options;
  /** @type {Report} */
  report;
  /** The GLB that is shown. @type {Uint8Array} */
  bytes;

  /** @param {string} model its name
   * @param {{ values: Values, options: RemeshOptions, report: Report }} run
   * @param {{ written: NamedBytes[], shown: Uint8Array }} content */
  constructor(model, { values, options, report }, { written, shown }) {
    this.#model = model;
    this.#written = written;
    this.values = values;
    this.options = options;
    this.report = report;
    this.bytes = shown;
  }

  /** The bytes that this result keeps. */
  get size() {
    const written = this.#format === 'glb' ? [] : this.#written;
    return written.reduce((sum, { bytes }) => sum + bytes.length, this.bytes.length);
  }

  /** The bytes of a file in a format; null if they are not known before it is made.
   * @param {string} format */
  sizeIn(format) {
    if (format === this.#format) {
      return this.#written.reduce((sum, { bytes }) => sum + bytes.length, 0);
    }
    const { triangles } = this.report.output;
    const known = /** @type {Record<string, number>} */ (
      { glb: this.bytes.length, gltf: this.bytes.length, stl: 84 + 50 * triangles });
    return known[format] ?? null;
  }

  /** The format that the run wrote. */
  get #format() {
    return extensionOf(this.#written[0].name);
  }

  /** The name of a file that is saved of this result. @param {string} extension
   * @param {string} [detail] see nameFor */
  nameIn(extension, detail) {
    return nameFor(this.#model, this.report, extension, detail);
  }

  /** The name of one file that a run writes with the same mesh. */
  get ownName() {
    return this.nameIn(this.#format === 'gltf' ? 'glb' : this.#format);
  }

  /** The files in a format. @param {string} format @param {ConvertOptions} how
   * @param {() => AbortSignal} begin called if the files are yet to be made
   * @returns {Promise<Saved>} */
  async filesIn(format, how, begin) {
    const { files, warnings } = await this.#converted(format, how, begin);
    const losses = format === this.#format ? [] : lossesIn(openGlb(this.bytes).tree, format);
    return { files, warnings: warnings.filter(({ code }) => code !== 'PARTS_MERGED'), losses };
  }

  /** @param {string} format @param {ConvertOptions} how @param {() => AbortSignal} begin
   * @returns {Promise<{ files: NamedBytes[], warnings: Warning[] }>} */
  async #converted(format, how, begin) {
    const name = this.nameIn(format);
    if (format === this.#format) {
      const [first, ...others] = this.#written;
      return { files: [{ name, bytes: first.bytes }, ...others], warnings: [] };
    }
    if (format === 'glb') return { files: [{ name, bytes: this.bytes }], warnings: [] };
    return convertWritten(this.#written, { ...how, output: name, signal: begin() });
  }
}

/** @param {NamedBytes[]} written a file and those that it refers to
 * @param {ConvertOptions & { output: string, signal: AbortSignal }} how output: a name or a
 *   format */
function convertWritten([first, ...resources], how) {
  return convertFile(first.bytes,
    { ...describe({ ...first, resources }), metres: false, ...how });
}

/** Those of some options that repair has. @param {RemeshOptions} options */
const ofRepair = (options) => Object.fromEntries(Object.entries(options).filter(([name]) =>
  repairNames.some((own) => own === name)));

/** Remeshes or repairs a model, as it was asked for.
 * @param {Model} model @param {Values} values
 * @param {RemeshOptions & import('remesher').OutputOptions & Partial<Watch>} options */
export function worked(model, values, options) {
  const { output, signal, onProgress } = options;
  const about = { ...describe(model), output, metres: false, signal, onProgress };
  return isRepairOnly(values)
    ? repairFile(model.content, { ...ofRepair(options), ...about })
    : remeshFile(model.content, { ...options, ...about });
}

/** @param {string} name */
const isWritten = (name) => formats.some((format) => format === extensionOf(name));

/** The result of a run on a model. A draft is only shown, so it is written as it is shown; what is
 * only repaired is written in its own format, so that what is sound keeps its bytes.
 * @param {Model} model @param {{ values: Values, extra: RemeshOptions }} asked
 * @param {Watch} watch */
export async function resultOf(model, { values, extra }, watch) {
  const options = { ...optionsIn(values), ...extra };
  const format = isRepairOnly(values) && isWritten(model.name) ? extensionOf(model.name)
    : formatOfRun(model, options);
  const { files, report } = await worked(model, values,
    { ...options, output: format, ...watch });
  const shown = format === 'glb' ? files[0].bytes
    : (await convertWritten(files, { output: 'glb', signal: watch.signal })).bytes;
  return new Result(model.name, { values, options, report }, { written: files, shown });
}
