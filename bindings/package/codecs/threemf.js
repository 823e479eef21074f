// SPDX-License-Identifier: MIT
// Opens and closes the ZIP package around a 3MF model, whose XML the core reads and writes. Source:
// Open Packaging Conventions, as the 3MF Core Specification 1.3 uses them.

import { RemeshError } from '../base/errors.js';
import { legible } from '../base/legible.js';
import { threemfNameOf } from '../base/lengths.js';
import { largestInflated } from './gunzip.js';

/** @typedef {import('../base/messages.js').FileRequest} FileRequest */
/** @typedef {import('../base/messages.js').NamedBytes} NamedBytes */

const mainPath = '3D/3dmodel.model';
const modelType = 'http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel';

const isZip = (/** @type {Uint8Array} */ bytes) =>
  bytes[0] === 0x50 && bytes[1] === 0x4b && bytes[2] === 3 && bytes[3] === 4;

const isThreemf = (/** @type {string} */ name) => /\.3mf$/i.test(name);

/**
 * Models and relationships of a package, by their paths; none if it is no 3MF.
 * @param {NamedBytes} file
 * @param {number} limit bytes of all models together
 */
async function modelsIn({ name, bytes }, limit) {
  const { unzipSync } = await import('../zip.mjs');
  let length = 0;
  try {
    return unzipSync(bytes, { filter: (/** @type {any} */ { name: path, originalSize }) => {
      const isWanted = /\.(model|rels)$/i.test(path);
      if (isWanted) length += originalSize;
      if (length > limit) {
        throw new RemeshError('UNSUPPORTED',
          `${legible(name)}: it unpacks to more than ${limit} bytes, which is the limit.`,
          'Give a smaller model.');
      }
      return isWanted;
    } });
  } catch (cause) {
    if (cause instanceof RemeshError) throw cause;
    throw new RemeshError('PARSE_ERROR', `${legible(name)}: its ZIP is damaged or cut short.`,
      'Was it copied completely?', { cause });
  }
}

/**
 * The path of the model that the package starts with.
 * @param {Record<string, Uint8Array>} models
 */
function startOf(models) {
  const relations = models['_rels/.rels'];
  const text = relations ? new TextDecoder().decode(relations) : '';
  const [relation] = text.match(/<[^>]*\/3dmodel"[^>]*>/) ?? [''];
  const target = /Target\s*=\s*"\/?([^"]*)"/.exec(relation)?.[1] ?? mainPath;
  return target in models ? target : Object.keys(models).find((path) => /\.model$/i.test(path));
}

/**
 * A 3MF's model in place of its package, with the package's other models; any other file as it is.
 * @param {FileRequest} file
 * @param {number} [limit]
 * @returns {Promise<FileRequest>}
 */
export async function unpackThreemf(file, limit = largestInflated) {
  if (!isZip(file.bytes)) return file;
  const models = await modelsIn(file, limit);
  const start = startOf(models);
  if (start === undefined) return file;
  const others = Object.entries(models).filter(([path]) => path !== start)
    .map(([name, bytes]) => ({ name, bytes }));
  return { ...file, bytes: models[start], resources: [...file.resources, ...others] };
}

/** @param {Uint8Array} a @param {Uint8Array} b */
const areEqual = (a, b) => a.length === b.length && a.every((byte, i) => byte === b[i]);

/** A model that states the unit that the caller has said. @param {Uint8Array} model
 * @param {unknown} unit */
function statingUnit(model, unit) {
  const name = threemfNameOf(unit);
  if (name === undefined) return model;
  const longest = 1024;
  const head = new TextDecoder().decode(model.subarray(0, longest));
  const [tag] = /<model\b[^>]*>/.exec(head) ?? [];
  if (tag === undefined) return model;
  const begin = new TextEncoder().encode(head.slice(0, head.indexOf(tag))).length;
  const end = begin + new TextEncoder().encode(tag).length;
  const stated = new TextEncoder().encode(tag.replace(/\bunit="[^"]*"/, `unit="${name}"`));
  const result = new Uint8Array(begin + stated.length + model.length - end);
  result.set(model.subarray(0, begin));
  result.set(stated, begin);
  result.set(model.subarray(end), begin + stated.length);
  return result;
}

/**
 * The model of a result in a package of its own, where it is a 3MF; any other file as it is. A
 * model that is the one that was read stays in its package.
 * @param {NamedBytes} file
 * @param {{ packed?: FileRequest, opened?: FileRequest, units?: unknown }} read the file that was
 *   read, and the unit that was said
 * @returns {Promise<NamedBytes>}
 */
export async function packThreemf({ name, bytes: model }, { packed, opened, units }) {
  if (!isThreemf(name)) return { name, bytes: model };
  const bytes = statingUnit(model, units);
  if (packed && opened && isZip(packed.bytes) && areEqual(bytes, opened.bytes)) {
    return { name, bytes: packed.bytes };
  }
  const { strToU8, zipSync } = await import('../zip.mjs');
  const head = '<?xml version="1.0" encoding="UTF-8"?>\n';
  const types = 'http://schemas.openxmlformats.org/package/2006/content-types';
  const relations = 'http://schemas.openxmlformats.org/package/2006/relationships';
  const entries = {
    '[Content_Types].xml': strToU8(`${head}<Types xmlns="${types}">`
      + '<Default Extension="rels" '
      + 'ContentType="application/vnd.openxmlformats-package.relationships+xml"/>'
      + '<Default Extension="model" '
      + 'ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>\n'),
    '_rels/.rels': strToU8(`${head}<Relationships xmlns="${relations}">`
      + `<Relationship Target="/${mainPath}" Id="rel0" Type="${modelType}"/></Relationships>\n`),
    [mainPath]: bytes,
  };
  // The same bytes at any time of day: the earliest date that a ZIP knows.
  return { name, bytes: zipSync(entries, { mtime: new Date(1980, 0, 1) }) };
}
