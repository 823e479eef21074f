// SPDX-License-Identifier: MIT
// The rooms of the tree and their order. A file may use its own room and those named after it here,
// which all stand before it: what is not named is above, or beside, and neither is allowed.

/** @type {Record<string, string[]>} folders of src; '' is src itself, the public functions */
export const coreRooms = {
  base: [],
  soup: ['base'],
  mesh: ['base', 'soup'],
  geometry: ['base', 'mesh'],
  charts: ['base', 'soup', 'mesh', 'geometry'],
  curves: ['base', 'mesh', 'geometry'],
  patches: ['base', 'mesh', 'geometry'],
  surface: ['base', 'mesh', 'geometry', 'curves'],
  operators: ['base', 'mesh', 'geometry', 'patches', 'surface'],
  gate: ['base', 'mesh', 'geometry', 'surface', 'operators'],
  thinning: ['base', 'mesh', 'geometry', 'surface', 'operators', 'gate'],
  steps: ['base', 'mesh', 'geometry', 'surface', 'operators', 'gate', 'thinning'],
  accuracy: ['base', 'mesh', 'geometry', 'surface', 'operators', 'gate', 'steps'],
  attributes: ['base', 'mesh', 'geometry', 'curves', 'surface', 'operators'],
  'remesh/quads/mesh': ['base', 'mesh', 'surface', 'operators'],
  'remesh/quads/field': ['base', 'mesh', 'geometry', 'operators'],
  'remesh/quads/map': ['base', 'mesh', 'operators', 'remesh/quads/field'],
  'remesh/quads/extract': ['base', 'mesh', 'surface', 'operators', 'remesh/quads/mesh',
    'remesh/quads/map'],
  'remesh/quads/pair': ['base', 'mesh', 'geometry', 'surface', 'operators', 'remesh/quads/mesh',
    'remesh/quads/field'],
  'remesh/quads/shape': ['base', 'mesh', 'geometry', 'surface', 'operators', 'remesh/quads/mesh'],
  'remesh/quads': ['base', 'mesh', 'geometry', 'surface', 'operators', 'remesh/quads/mesh',
    'remesh/quads/field', 'remesh/quads/map', 'remesh/quads/extract', 'remesh/quads/pair',
    'remesh/quads/shape'],
  schemes: ['base', 'soup', 'mesh', 'geometry', 'curves', 'surface', 'operators', 'gate',
    'thinning', 'steps', 'accuracy', 'attributes', 'remesh/quads/mesh', 'remesh/quads'],
  measure: ['base', 'soup', 'geometry'],
  'io/model': ['base'],
  'io/text': ['base', 'io/model'],
  'io/ply': ['base', 'io/model', 'io/text'],
  'io/stl': ['base', 'io/model', 'io/text'],
  'io/gltf': ['base', 'io/model'],
  io: ['base', 'io/model', 'io/text', 'io/ply', 'io/stl', 'io/gltf'],
  parts: ['base', 'soup', 'geometry', 'attributes', 'measure', 'io/model'],
  painting: ['base', 'soup', 'mesh', 'geometry', 'io/model'],
  '': ['base', 'geometry', 'charts', 'schemes', 'measure', 'io/model', 'io', 'parts', 'painting'],
};

/** @type {Record<string, string[]>} folders of bindings/package; '': what is imported by name */
export const packageRooms = {
  base: [],
  codecs: ['base'],
  files: ['base'],
  textures: ['base', 'codecs'],
  worker: ['base', 'codecs', 'textures'],
  api: ['base', 'worker'],
  adapters: ['base'],
  '': ['base', 'textures', 'worker', 'api'],
  cli: ['base', 'codecs', 'files', 'api', ''],
};

/** @type {Record<string, string[]>} folders of web; '': the page, what builds and serves it */
export const pageRooms = {
  texts: [],
  base: ['texts'],
  files: ['base'],
  model: ['base', 'files'],
  triangles: ['base'],
  view: ['base', 'files', 'triangles'],
  survey: [],
  panel: ['base', 'files', 'model', 'view', 'survey'],
  report: ['base', 'files', 'model', 'view', 'survey', 'panel'],
  acts: ['base', 'files', 'model', 'view', 'survey', 'panel', 'report'],
  samples: [],
  '': ['texts', 'base', 'files', 'model', 'view', 'panel', 'report', 'acts', 'samples'],
};

/** @param {string} path from the rooms' top */
const roomOf = (path) => path.split('/').slice(0, -1).join('/');

/**
 * The arrows that do not point down: from a file to another, both by their paths from the top.
 * @param {Record<string, string[]>} rooms
 * @param {Iterable<readonly [string, readonly string[]]>} arrows
 */
export function wrongArrows(rooms, arrows) {
  const wrong = [];
  for (const [file, targets] of arrows) {
    const allowed = [roomOf(file), ...(rooms[roomOf(file)] ?? [])];
    wrong.push(...targets.filter((target) => !allowed.includes(roomOf(target)))
      .map((target) => `${file} -> ${target}`));
  }
  return wrong;
}

/**
 * The first circle in a graph of names, or none.
 * @param {Map<string, readonly string[]>} graph
 */
export function findCircle(graph) {
  const state = new Map();
  const visit = (/** @type {string} */ node, /** @type {string[]} */ path) => {
    if (state.get(node) === 'done') return undefined;
    if (state.get(node) === 'open') return [...path.slice(path.indexOf(node)), node];
    state.set(node, 'open');
    for (const next of graph.get(node) ?? []) {
      const circle = visit(next, [...path, node]);
      if (circle) return circle;
    }
    state.set(node, 'done');
    return undefined;
  };
  for (const node of graph.keys()) {
    const circle = visit(node, []);
    if (circle) return circle;
  }
  return undefined;
}
