// SPDX-License-Identifier: MIT
// Painted maps that say the same everywhere need no image: one value becomes a factor of its
// material, and normals that nowhere differ from the surface's are left out.

/** @typedef {import('../base/messages.js').Picture} Picture */
/** @typedef {number[]} Value red, green, blue, alpha, 0 to 255 */

const placeholder = /^painting:(\d+)$/;

/** Levels by which texels of one value may differ: by rounding, and less than is seen. */
const mostApart = 2;

/** The texel that says nothing in a map of normals. */
const upright = [128, 128, 255];

/** The value of all texels, if they have one. @param {Picture} picture
 * @returns {Value | undefined} */
export function oneValue({ texels }) {
  const low = [255, 255, 255, 255];
  const high = [0, 0, 0, 0];
  for (let i = 0; i < texels.length; i += 4) {
    for (let k = 0; k < 4; k += 1) {
      const level = texels[i + k];
      if (level < low[k]) low[k] = level;
      if (level > high[k]) high[k] = level;
      if (high[k] - low[k] > mostApart) return undefined;
    }
  }
  return low.map((level, k) => (level + high[k]) / 2);
}

/** The linear light of an sRGB level. @param {number} level */
function light(level) {
  const s = level / 255;
  return s <= 0.04045 ? s / 12.92 : ((s + 0.055) / 1.055) ** 2.4;
}

/** @param {number[] | undefined} factor @param {number[]} by */
const times = (factor, by) => by.map((x, k) => x * (factor?.[k] ?? 1));

/** What each map of a material becomes if it has one value; undefined: it must stay.
 * @type {Record<string, (material: any, value: Value) => (() => void) | undefined>} */
const factors = {
  baseColorTexture: ({ pbrMetallicRoughness: pbr }, [r, g, b, a]) => () => {
    pbr.baseColorFactor = times(pbr.baseColorFactor, [light(r), light(g), light(b), a / 255]);
    delete pbr.baseColorTexture;
  },
  metallicRoughnessTexture: ({ pbrMetallicRoughness: pbr }, [, g, b]) => () => {
    pbr.roughnessFactor = (pbr.roughnessFactor ?? 1) * (g / 255);
    pbr.metallicFactor = (pbr.metallicFactor ?? 1) * (b / 255);
    delete pbr.metallicRoughnessTexture;
  },
  occlusionTexture: (material, [r]) => (r < 255 - mostApart ? undefined : () => {
    delete material.occlusionTexture;
  }),
  emissiveTexture: (material, [r, g, b]) => () => {
    material.emissiveFactor = times(material.emissiveFactor, [light(r), light(g), light(b)]);
    delete material.emissiveTexture;
  },
  normalTexture: (material, value) =>
    (upright.some((level, k) => Math.abs(value[k] - level) > mostApart) ? undefined : () => {
      delete material.normalTexture;
    }),
};

/** The maps of a material, by their names in `factors`. @param {any} material */
const mapsOf = (material) => ({
  baseColorTexture: material.pbrMetallicRoughness?.baseColorTexture,
  metallicRoughnessTexture: material.pbrMetallicRoughness?.metallicRoughnessTexture,
  occlusionTexture: material.occlusionTexture,
  emissiveTexture: material.emissiveTexture,
  normalTexture: material.normalTexture,
});

/** The numbers of the painted images that a map shows. @param {any} tree @param {any} info */
function paintedBy(tree, info) {
  const texture = tree.textures?.[info?.index];
  const sources = [texture?.source, ...Object.values(Object(texture?.extensions))
    .map((extension) => extension?.source)];
  return sources.map((source) => placeholder.exec(tree.images?.[source]?.uri ?? '')?.[1])
    .filter((number) => number !== undefined).map(Number);
}

/** Calls visit for each reference to a texture. @param {any} value @param {(info: any) => void}
 *   visit */
function forEachInfo(value, visit) {
  if (typeof value !== 'object' || value === null) return;
  if (Number.isInteger(value.index)) visit(value);
  for (const member of Object.values(value)) forEachInfo(member, visit);
}

/** Drops members of a list that nothing refers to.
 * @param {any} tree @param {string} name of the list
 * @param {(visit: (holder: any, key: string) => void) => void} forEachReference */
function keepUsed(tree, name, forEachReference) {
  /** @type {Set<number>} */
  const used = new Set();
  forEachReference((holder, key) => used.add(holder[key]));
  const kept = [...used].sort((a, b) => a - b);
  const numbers = new Map(kept.map((old, number) => [old, number]));
  forEachReference((holder, key) => { holder[key] = numbers.get(holder[key]); });
  const list = kept.map((old) => tree[name][old]);
  if (list.length > 0) tree[name] = list;
  else delete tree[name];
}

/** @param {any} tree @param {(holder: any, key: string) => void} visit */
function forEachImage(tree, visit) {
  for (const texture of tree.textures ?? []) {
    for (const holder of [texture, ...Object.values(Object(texture.extensions))]) {
      if (Number.isInteger(holder?.source)) visit(holder, 'source');
    }
  }
}

/** @param {any} tree */
function dropUnused(tree) {
  keepUsed(tree, 'textures', (visit) =>
    forEachInfo(tree.materials ?? [], (info) => visit(info, 'index')));
  keepUsed(tree, 'images', (visit) => forEachImage(tree, visit));
  const isWebp = (tree.textures ?? []).some((/** @type {any} */ texture) =>
    texture.extensions?.EXT_texture_webp);
  if (isWebp) return;
  for (const list of ['extensionsUsed', 'extensionsRequired']) {
    if (!tree[list]) continue;
    tree[list] = tree[list].filter((/** @type {string} */ name) => name !== 'EXT_texture_webp');
    if (tree[list].length === 0) delete tree[list];
  }
}

/**
 * Replaces painted maps of one value by factors, in place.
 * @param {any} tree of a glTF file whose images are named `painting:n`
 * @param {readonly (Value | undefined)[]} values of the images
 */
export function replacePlainMaps(tree, values) {
  const isPointedTo = tree.extensionsUsed?.includes('KHR_animation_pointer');
  if (isPointedTo || values.every((value) => value === undefined)) return;
  for (const material of tree.materials ?? []) {
    for (const [name, info] of Object.entries(mapsOf(material))) {
      const painted = paintedBy(tree, info);
      const value = painted.length > 0 ? values[painted[0]] : undefined;
      if (value) factors[name](material, value)?.();
    }
  }
  dropUnused(tree);
}
