// SPDX-License-Identifier: MIT
// The rooms of the tree and their order. A file may use its own room and the rooms listed for it
// here, which all come before it. Other rooms are above or beside it and must not be used.

/** @type {Record<string, string[]>} folders of src; '' is src itself, the public functions */
export const coreRooms = {
  base: [],
  mesh: ['base'],
  geometry: ['base', 'mesh'],
  'original/curves': ['base', 'mesh', 'geometry'],
  'original/patches': ['base', 'mesh', 'geometry'],
  'original/surface': ['base', 'mesh', 'geometry', 'original/curves'],
  simplify: ['base', 'mesh', 'geometry'],
  'remesh/operators': ['base', 'mesh', 'geometry', 'original/patches', 'original/surface'],
  'remesh/gate': ['base', 'mesh', 'geometry', 'original/surface', 'remesh/operators'],
  'remesh/ground': ['base', 'mesh', 'geometry', 'original/surface', 'remesh/operators',
    'remesh/gate'],
  'remesh/steps': ['base', 'mesh', 'geometry', 'original/surface', 'remesh/operators',
    'remesh/gate', 'remesh/ground'],
  'remesh/accuracy': ['base', 'mesh', 'geometry', 'original/surface', 'remesh/operators',
    'remesh/gate', 'remesh/ground', 'remesh/steps'],
  'remesh/transfer': ['base', 'mesh', 'geometry', 'original/surface', 'remesh/operators'],
  'remesh/conforming': ['base', 'mesh', 'geometry', 'original/curves'],
  'remesh/guides': ['base', 'mesh', 'geometry'],
  'remesh/quads/mesh': ['base', 'mesh', 'geometry', 'original/surface', 'remesh/operators'],
  'remesh/symmetry': ['base', 'mesh', 'geometry', 'original/surface', 'remesh/operators',
    'remesh/transfer', 'remesh/guides', 'remesh/quads/mesh'],
  'remesh/quads/field': ['base', 'mesh', 'geometry', 'original/surface', 'remesh/operators'],
  'remesh/quads/map': ['base', 'mesh', 'remesh/operators', 'remesh/quads/field'],
  'remesh/quads/extract': ['base', 'mesh', 'original/surface', 'remesh/operators',
    'remesh/quads/mesh', 'remesh/quads/map'],
  'remesh/quads/pair': ['base', 'mesh', 'geometry', 'original/surface', 'remesh/operators',
    'remesh/quads/mesh', 'remesh/quads/field'],
  'remesh/quads/shape': ['base', 'mesh', 'geometry', 'original/surface', 'remesh/operators',
    'remesh/quads/mesh'],
  'remesh/quads': ['base', 'mesh', 'geometry', 'original/surface', 'remesh/operators',
    'remesh/quads/mesh', 'remesh/quads/field', 'remesh/quads/map', 'remesh/quads/extract',
    'remesh/quads/pair', 'remesh/quads/shape'],
  'remesh/schemes': ['base', 'mesh', 'geometry', 'original/curves', 'original/surface',
    'simplify', 'remesh/operators', 'remesh/gate', 'remesh/ground', 'remesh/steps',
    'remesh/accuracy', 'remesh/transfer', 'remesh/conforming', 'remesh/guides',
    'remesh/quads/mesh', 'remesh/quads', 'remesh/symmetry'],
  measure: ['base', 'mesh', 'geometry'],
  arrangement: ['base', 'mesh', 'geometry', 'measure'],
  contact: ['base', 'mesh', 'geometry', 'arrangement'],
  'repair/holes': ['base', 'mesh', 'geometry', 'measure'],
  'repair/solid': ['base', 'mesh', 'geometry', 'measure'],
  repair: ['base', 'mesh', 'geometry', 'measure', 'arrangement', 'contact', 'repair/holes',
    'repair/solid'],
  'io/model': ['base', 'mesh'],
  'io/text': ['base', 'geometry', 'io/model'],
  'io/ply': ['base', 'geometry', 'io/model', 'io/text'],
  'io/stl': ['base', 'io/model', 'io/text'],
  'io/named': ['base', 'geometry', 'io/model', 'io/text'],
  'io/gltf/tree': ['base', 'io/model'],
  'io/gltf/library': ['base', 'io/model'],
  'io/gltf': ['base', 'io/model', 'io/gltf/tree', 'io/gltf/library'],
  io: ['base', 'io/model', 'io/text', 'io/ply', 'io/stl', 'io/named', 'io/gltf'],
  'textures/charts': ['base', 'mesh', 'geometry'],
  'textures/painting': ['base', 'mesh', 'geometry', 'io/model'],
  textures: ['base', 'mesh', 'geometry', 'io/model', 'textures/charts', 'textures/painting'],
  'jobs/parts': ['base', 'mesh', 'geometry', 'remesh/schemes', 'measure', 'io/model'],
  'jobs/checks': ['base', 'mesh', 'geometry', 'remesh/schemes', 'measure', 'io/model',
    'jobs/parts'],
  jobs: ['base', 'mesh', 'geometry', 'simplify', 'remesh/schemes', 'measure', 'contact', 'repair',
    'io/model', 'io', 'textures', 'jobs/parts', 'jobs/checks'],
  '': ['base', 'mesh', 'remesh/quads', 'remesh/schemes', 'measure', 'io/model', 'io', 'jobs/parts',
    'jobs/checks', 'jobs'],
};

/** @type {Record<string, string[]>} folders of bindings/package; '': modules imported by name */
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

/** @type {Record<string, string[]>} folders of web; '': the page, its build and its server */
export const pageRooms = {
  'texts/diagnostics': [],
  'texts/options': [],
  texts: ['texts/diagnostics', 'texts/options'],
  base: ['texts'],
  files: ['base'],
  model: ['base', 'files'],
  triangles: ['base'],
  view: ['base', 'files', 'triangles'],
  survey: ['triangles'],
  panel: ['base', 'files', 'model', 'view', 'survey'],
  report: ['base', 'files', 'model', 'view', 'survey', 'panel'],
  acts: ['base', 'files', 'model', 'view', 'survey', 'panel', 'report'],
  samples: [],
  scenes: [],
  '': ['texts', 'base', 'files', 'model', 'view', 'panel', 'report', 'acts', 'samples'],
};

/** @param {string} path from the rooms' top */
const roomOf = (path) => path.split('/').slice(0, -1).join('/');

/**
 * The arrows that do not point down, from file to file, by their paths from the rooms' top.
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
 * The first cycle in a graph of names, or none.
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
