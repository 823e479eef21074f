// SPDX-License-Identifier: MIT
// Whether new textures serve a glTF file better than its own: only then does a preset bake them.

/** How a material is drawn: materials of one kind can share a set of maps.
 * @param {{ alphaMode?: string, doubleSided?: boolean, extensions?: any }} material */
const kindOf = ({ alphaMode = 'OPAQUE', doubleSided = false, extensions = {} }) =>
  `${alphaMode} ${doubleSided} ${'KHR_materials_unlit' in extensions}`;

const triangleList = 4;

/** The share of its triangles that a model must keep to look best with its own textures, or with no
 * map of normals if it has none: in general, where seams have at most one vertex for so many
 * triangles of the budget, and without textures. */
const [leastOfSeamed, leastOfWhole, leastOfBare, trianglesPerSeam] = [1 / 4, 1 / 10, 3 / 4, 8];

/** A result so near, in percent of the diagonal, shows its shape best without a map of normals. */
const nearEnough = 0.1;

/** The triangles of a file, and about how many vertices lie on seams and boundaries: a closed
 * surface without any has half as many vertices as triangles, and these make up half of each cut.
 * @param {any} tree of a glTF file */
function sizesOf({ meshes = [], accessors = [] }) {
  let [triangles, vertices] = [0, 0];
  for (const { mode = triangleList, indices, attributes } of
    meshes.flatMap((/** @type {any} */ { primitives }) => primitives)) {
    if (mode !== triangleList) continue;
    triangles += accessors[indices ?? attributes.POSITION].count / 3;
    vertices += accessors[attributes.POSITION].count;
  }
  return { triangles, seams: vertices - triangles / 2 };
}

/**
 * Whether the preset `asset` bakes new textures: several materials become one. Triangles that all
 * stay keep their own texture coordinates. So does a surface that is not reduced much and has fewer
 * vertices on seams than the budget has triangles: its texels stay sharp. So do cards whose alpha
 * cuts them out: many leaves share the texels of one. What is blended is baked: later triangles lie
 * over earlier ones, and new textures show that order best.
 * @param {any} tree of a glTF file, its JSON
 * @param {number} faces the budget; 0: there is none
 * @returns {boolean}
 */
export function isWorthBaking(tree, faces) {
  try {
    const { materials = [], textures = [] } = tree;
    if (new Set(materials.map(kindOf)).size < materials.length) return true;
    if (materials.some((/** @type {any} */ { alphaMode }) => alphaMode === 'MASK')) return false;
    const { triangles, seams } = sizesOf(tree);
    if (materials.some((/** @type {any} */ { alphaMode }) => alphaMode === 'BLEND')) {
      return faces < triangles;
    }
    const least = textures.length === 0 ? leastOfBare
      : trianglesPerSeam * seams <= faces ? leastOfWhole : leastOfSeamed;
    const isMild = seams <= faces && faces >= least * triangles;
    return !isMild && faces < triangles;
  } catch {
    return true; // the engine says what is wrong with the file
  }
}

/**
 * Whether all that was baked are normals that nobody needs: the result shows the shape itself.
 * @param {any} tree of the given file
 * @param {{ hausdorff: number } | null} [fidelity] of the result
 * @returns {boolean}
 */
export function isBakedInVain({ materials = [], textures = [], meshes = [] }, fidelity) {
  const isColoured = meshes.some((/** @type {any} */ { primitives }) =>
    primitives.some((/** @type {any} */ { attributes }) => 'COLOR_0' in attributes));
  return Boolean(fidelity) && Number(fidelity?.hausdorff) < nearEnough && !isColoured
    && textures.length === 0 && new Set(materials.map(kindOf)).size === materials.length;
}
