// SPDX-License-Identifier: MIT
// What a message advises can be followed: the number that it names is enough, the option that it
// names helps, and what it calls damaged is.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { inspect, remesh, remeshFile, repair, repairFile } from 'remesher';

import { errorCodes } from '../../bindings/package/base/errors.js';
import { GltfMaker } from '../support/gltf.js';
import { ktx2 } from '../support/ktx2.js';
import { gear } from '../support/machine_parts.js';
import { png } from '../support/png.js';
import { offText, sheet, stl, torus } from '../support/shapes.js';
import { filesUnder, readText } from '../support/tree.js';

const ball = torus({ columns: 24, rows: 12 });
const bytesOf = (text) => new TextEncoder().encode(text);

/** A tetrahedron for Gmsh: its sides, and its inside where asked for. */
function gmshText({ isSolid = false } = {}) {
  const elements = ['2 0 1 3 2', '2 0 1 2 4', '2 0 2 3 4', '2 0 3 1 4',
    ...(isSolid ? ['4 0 1 2 3 4'] : [])];
  return ['$MeshFormat', '2.2 0 8', '$EndMeshFormat', '$Nodes', 4, '1 0 0 0', '2 1 0 0', '3 0 1 0',
    '4 0 0 1', '$EndNodes', '$Elements', elements.length,
    ...elements.map((element, i) => `${i + 1} ${element}`), '$EndElements', ''].join('\n');
}

/** A GLB with a torus for each size, side by side. */
function toriOf(sizes) {
  const maker = new GltfMaker();
  const meshes = sizes.map((size) => ({ primitives: [{
    attributes: { POSITION: maker.add(ball.positions.map((x) => Math.fround(size * x)), 'VEC3') },
    indices: maker.addIndices(Uint16Array.from(ball.indices)),
  }] }));
  maker.show(meshes[0].primitives);
  Object.assign(maker.tree, { meshes, nodes: meshes.map((_, mesh) => ({ mesh })) });
  maker.tree.scenes[0].nodes = meshes.map((_, i) => i);
  return maker.glb();
}

/** The error of a run, and the number that its hint names. */
async function refusal(bytes, options) {
  const error = await remeshFile(bytes, options).then(() => undefined, (reason) => reason);
  assert.ok(error, 'it was not refused');
  return { error, number: Number(/Ask for (\d+) vertices/.exec(error.hint ?? '')?.[1]) };
}

test('of a file with several meshes the number that is named is enough for all', async () => {
  for (const sizes of [[1, 1], [1, 0.01, 0.01, 5], [3, 2, 1]]) {
    const { bytes, name } = toriOf(sizes);
    const { error, number } = await refusal(bytes, { name, vertices: 12 });
    assert.equal(error.code, 'TARGET_TOO_SMALL');
    assert.match(error.message, /12 vertices is too small for all \d meshes/);
    assert.ok(!/of 0 vertices/.test(error.message));
    const { report } = await remeshFile(bytes, { name, vertices: number });
    assert.equal(report.output.vertices, number);
  }
});

test('loose triangles are joined by the tolerance that is named', async () => {
  const loose = [...ball.indices].flatMap((v, i) =>
    [0, 1, 2].map((k) => ball.positions[3 * v + k] + 1e-6 * ((i + k) % 3)));
  const text = offText({ positions: Float64Array.from(loose),
    indices: Uint32Array.from(ball.indices.keys()) });
  const bytes = new TextEncoder().encode(text);
  const { warnings } = await inspect(bytes, { name: 'loose.off' });
  const { message } = warnings.find(({ code }) => code === 'TRIANGLES_NOT_JOINED');
  const weld = Number(/ weld: ([\d.e-]+)/.exec(message)[1]);
  const { report } = await remeshFile(bytes, { name: 'loose.off', vertices: 200, weld });
  assert.equal(report.output.vertices, 200);
  assert.equal(report.output.boundaryEdges, 0);
  assert.ok(!report.warnings.some(({ code }) => code === 'TRIANGLES_NOT_JOINED'));
});

test('capitals in a name are a name', async () => {
  const { positions, indices } = sheet(6);
  const maker = new GltfMaker();
  maker.show([{ attributes: { POSITION: maker.add(positions, 'VEC3'),
    COLOR_0: maker.add(positions.map((x) => Math.min(1, Math.abs(x))), 'VEC3') },
  indices: maker.addIndices(Uint16Array.from(indices)) }]);
  const { bytes } = maker.glb();
  const options = { vertices: 30, textures: 'bake', textureSize: 64, textureFormat: 'png' };
  const result = await remeshFile(bytes, { ...options, name: 'A.GLB', output: 'X.GLB' });
  assert.equal(result.report.output.vertices, 30);
  const { code, message } = await remeshFile(Uint8Array.of(1, 2, 3, 4), { name: 'B.GLB' })
    .then(assert.fail, (error) => error);
  assert.equal(code, 'PARSE_ERROR');
  assert.match(message, /does not begin as a binary glTF/);
});

test('what an unknown extension makes of a file is not called damaged', async () => {
  const maker = new GltfMaker();
  maker.show([{ attributes: { POSITION: maker.add(ball.positions, 'VEC3') },
    indices: maker.addIndices(Uint16Array.from(ball.indices, (v) => v + 1000)) }]);
  const { bytes: damaged } = maker.glb();
  const { error } = await refusal(damaged, { name: 'a.glb' });
  assert.equal(error.code, 'INDEX_OUT_OF_RANGE');
  maker.tree.extensionsUsed = ['ACME_other_numbers'];
  maker.tree.extensionsRequired = ['ACME_other_numbers'];
  const { error: unknown } = await refusal(maker.glb().bytes, { name: 'a.glb' });
  assert.equal(unknown.code, 'UNSUPPORTED');
  assert.match(unknown.message, /requires ACME_other_numbers, which is not known here/);
});

/** A sheet as glTF; `change` has a say in it. */
function sheetFile(change = () => {}) {
  const { positions, indices } = sheet(8);
  const maker = new GltfMaker();
  const primitive = { attributes: { POSITION: maker.add(positions, 'VEC3'),
    TEXCOORD_0: maker.add(positions.filter((_, i) => i % 3 < 2), 'VEC2') },
  indices: maker.addIndices(Uint16Array.from(indices)), material: 0 };
  Object.assign(maker.tree, { materials: [{ pbrMetallicRoughness: { baseColorTexture:
    { index: 0 } } }], textures: [{ source: 0 }], images: [{ mimeType: 'image/png',
    bufferView: maker.addView(png(8, 8, (x, y) => [9 * x, 9 * y, 0])) }] });
  maker.show([primitive]);
  change(maker.tree, primitive, maker);
  return maker.glb().bytes;
}

const hidden = { KHR_node_visibility: { visible: false } };
const withHidden = sheetFile((tree) => {
  tree.scenes[0].nodes = [0, tree.nodes.push({ mesh: 0, extensions: hidden }) - 1];
});
const ktx = sheetFile((tree, _, maker) => {
  const bytes = ktx2(1, 1, () => [1, 2, 3]);
  bytes[12] = 37; // VK_FORMAT_R8G8B8A8_UNORM
  tree.images = [{ bufferView: maker.addView(bytes), mimeType: 'image/ktx2' }];
  tree.textures = [{ extensions: { KHR_texture_basisu: { source: 0 } } }];
});
const notGiven = sheetFile((tree) => {
  tree.images = [{ uri: 'paint.png' }];
});
const painted = { textures: 'bake', textureSize: 64, textureFormat: 'png', vertices: 40 };
const far = bytesOf(offText({ positions: Float64Array.from(ball.positions, (x) => 5e6 + x),
  indices: ball.indices }));
const large = bytesOf(offText({
  positions: Float64Array.from(ball.positions, (x) => 1e300 * x), indices: ball.indices }));
const utf16 = Buffer.from(`\ufeff${offText(ball)}`, 'utf16le');

const inFile = (bytes, options) => () => remeshFile(bytes, options);
const inArrays = (options, mesh = ball) => () => remesh(mesh, options);
const mesh = (options) => ({ name: 'a.glb', vertices: 40, ...options });

/**
 * What provokes a message of a code, what the message advises, and what follows it: runs, or a
 * function of the words that makes them.
 * @type {[string, () => Promise<any>, RegExp, ...((words: RegExpExecArray) => Promise<any>)[]][]}
 */
const advice = [
  ['PARTS_MEET', () => repairFile(toriOf([1, 0.9]).bytes, { name: 'a.glb' }), /In an \.stl file/,
    () => repairFile(toriOf([1, 0.9]).bytes, { name: 'a.glb', output: 'a.stl' })],
  ['TARGET_TOO_SMALL', inArrays({ vertices: 3 }), /for this surface\. Ask for (\d+)/,
    ([, number]) => remesh(ball, { vertices: Number(number) })],
  ['TARGET_TOO_SMALL', inArrays({ edgeLength: 100 }), /Ask for a shorter edge length/,
    inArrays({ edgeLength: 1 })],
  ['TARGET_TOO_SMALL', inFile(bytesOf(offText(ball)), { name: 'a.off', edgeLength: 100 }),
    /Ask for a shorter edge length/],
  ['TARGET_BELOW_CURVES', inFile(bytesOf(offText(sheet(8))), { name: 'a.off', vertices: 4,
    featureAngle: 1, boundary: 'keep' }), /Ask for (\d+) vertices.*fewer features \(featureAngle/,
  ([, number]) => remesh(sheet(8), { vertices: Number(number), featureAngle: 1, boundary: 'keep' }),
  () => remesh(sheet(8), { vertices: 20, featureAngle: 'off' })],
  ['INVALID_OPTION', inArrays({ vertices: 40, ratio: 2 }), /Leave out one of them/,
    inArrays({ ratio: 2 })],
  ['INVALID_OPTION', inArrays({ scheme: 'rounds', prefer: 'shape' }), /Leave out one of them/,
    inArrays({ scheme: 'rounds', vertices: 80 }), inArrays({ prefer: 'shape', vertices: 80 })],
  ['INVALID_OPTION', inArrays({ holesUpTo: 5, vertices: 80 }), /repair: 'holes'/,
    inArrays({ holesUpTo: 5, repair: 'holes', vertices: 80 })],
  ['INVALID_OPTION', inArrays({ repair: 'holes', featureEdges: [[0, 1]] }), /Leave out one of them/,
    async () => remesh((await repair(ball, { repair: 'holes' })).mesh,
      { vertices: 80, featureEdges: [[0, 1]] })],
  ['INVALID_OPTION', inArrays({ textures: 'bake' }), /Give the file, .* to remeshFile/,
    inFile(sheetFile(), mesh(painted))],
  ['INVALID_OPTION', inArrays({ featureEdges: [[0, 40]], vertices: 80 }), /that an edge of a tri/,
    inArrays({ featureEdges: [[0, 1]], vertices: 80 })],
  ['INVALID_OPTION', inFile(sheetFile(), mesh({ lodFiles: true })), /Add lods\.$/,
    inFile(sheetFile(), mesh({ lodFiles: true, lods: [0.5] }))],
  ['INVALID_OPTION', inFile(sheetFile(), mesh({ lods: [0.5], output: 'a.obj' })),
    /Name the output \.glb or \.gltf, or .* lodFiles\./,
    inFile(sheetFile(), mesh({ lods: [0.5], output: 'b.glb' })),
    inFile(sheetFile(), mesh({ lods: [0.5], output: 'a.obj', lodFiles: true }))],
  ['UNKNOWN_OPTION', inArrays({ vertexes: 80 }), /Did you mean (\w+)/,
    ([, name]) => remesh(ball, { [name]: 80 })],
  ['UNKNOWN_FORMAT', inFile(bytesOf(offText(ball)).subarray(4), { name: 'a.txt',
    output: 'a.off' }), /ends in .*\.off/,
    inFile(bytesOf(offText(ball)), { name: 'a.off', vertices: 80 })],
  ['UNKNOWN_FORMAT', inFile(sheetFile(), mesh({ output: 'a.fbx' })), /Let its name end in .*\.glb/,
    inFile(sheetFile(), mesh({ output: 'a.glb' }))],
  ['UNSUPPORTED', inFile(sheetFile(), mesh({ ...painted, output: 'a.obj' })), /end in \.glb or \./,
    inFile(sheetFile(), mesh({ ...painted, output: 'a.glb' }))],
  ['UNSUPPORTED', inFile(ktx, mesh(painted)), /or keep the textures/, inFile(ktx, mesh())],
  ['UNSUPPORTED', inFile(large, mesh({ name: 'a.off', output: 'a.stl' })), /Write OBJ or OFF/,
    inFile(large, mesh({ name: 'a.off', output: 'a.obj' })),
    inFile(large, mesh({ name: 'a.off', output: 'a.off' }))],
  ['UNSUPPORTED', inFile(large, mesh({ name: 'a.off', output: 'a.glb' })), /Write OBJ or OFF/],
  ['UNSUPPORTED', inFile(utf16, { name: 'a.off' }), /Save it as UTF-8/,
    inFile(bytesOf(offText(ball)), { name: 'a.off', vertices: 80 })],
  ['MISSING_RESOURCE', inFile(notGiven, mesh(painted)), /Give the image with the file, or keep/,
    inFile(notGiven, mesh({ ...painted, resources: { 'paint.png': png(8, 8, () => [9, 9, 9]) } })),
    inFile(notGiven, mesh())],
  ['NO_TRIANGLES', inFile(sheetFile((tree) => {
    tree.nodes[0].extensions = hidden;
  }), mesh({ output: 'a.stl' })), /Write a \.glb or \.gltf/,
  inFile(withHidden, mesh({ output: 'a.glb' }))],
  ['HIDDEN_LEFT_OUT', inFile(withHidden, mesh({ output: 'a.stl' })), /write a \.glb or \.gltf/,
    inFile(withHidden, mesh({ output: 'a.gltf' }))],
  ['MATERIAL_IMAGES_NOT_READ', inFile(sheetFile(), mesh({ output: 'a.off' })),
    /write a \.glb or \.gltf/, inFile(sheetFile(), mesh({ output: 'a.gltf' }))],
  ['ROUNDED_FAR_FROM_ORIGIN', inFile(far, mesh({ name: 'a.off', output: 'a.stl' })),
    /Write a \.ply or \.obj/, inFile(far, mesh({ name: 'a.off', output: 'a.ply' }))],
  ['RESOURCE_NOT_GIVEN', inFile(notGiven, mesh()), /was not given/,
    inFile(notGiven, mesh({ resources: { 'paint.png': png(8, 8, () => [9, 9, 9]) } }))],
  ['ELEMENTS_LEFT_OUT',
    inFile(bytesOf(gmshText({ isSolid: true })), mesh({ name: 'a.msh', vertices: 4 })),
    /only surfaces/, inFile(bytesOf(gmshText()), mesh({ name: 'a.msh', vertices: 4 }))],
  ['QUADS_TOO_FEW', inArrays({ quads: true, vertices: 30, symmetry: 'off' }, gear()),
    /Ask for more/, inArrays({ quads: true, vertices: 900, symmetry: 'off' }, gear())],
  ['ANGLES_WORSE', inArrays({ vertices: 5 }), /More vertices help/, inArrays({ vertices: 300 })],
  ['EDGES_TOO_LONG', inArrays({ vertices: 60, maxEdge: 0.4 }), /about (\d+) would/,
    (words) => remesh(ball, { vertices: Math.round(1.2 * words[1]), maxEdge: 0.4 })],
  ['EDGES_TOO_SHORT', inArrays({ vertices: 800, minEdge: 0.5 }), /about (\d+) would/,
    (words) => remesh(ball, { vertices: Math.round(words[1] / 1.2), minEdge: 0.5 })],
  ['INVALID_MESH', () => {
    const positions = ball.positions.slice();
    structuredClone(positions, { transfer: [positions.buffer] });
    return remesh({ positions, indices: ball.indices });
  }, /give a copy there, or here/, inArrays({ vertices: 80 }, { ...ball,
    positions: ball.positions.slice() })],
  ['INDEX_OUT_OF_RANGE', inArrays({}, { ...ball, indices: ball.indices.map((v) => v + 1) }),
    /Indices count from 0/, inArrays({ vertices: 80 })],
  ['NON_FINITE', inArrays({}, { ...ball, positions: ball.positions.map((x) => x / 0) }),
    /Repair or remove/, inArrays({ vertices: 80 })],
  ['EMPTY_FILE', inFile(new Uint8Array(), { name: 'a.stl' }), /Was it copied completely/,
    inFile(stl(ball), { name: 'a.stl', vertices: 80 })],
  ['PARSE_ERROR', inFile(stl(ball).subarray(0, 200), { name: 'a.stl' }), /Was it copied compl/,
    inFile(stl(ball), { name: 'a.stl', vertices: 80 })],
];

/** What is said is all there is to do, but for what other tests follow. */
const others = ['INTERNAL', 'CANCELLED',
  // tests/package/out_of_memory.test.js; a number that fits just so takes too long here
  'OUT_OF_MEMORY',
  'INPUT_UNREADABLE', 'OUTPUT_UNWRITABLE', // tests/cli/cli.test.js
  'TRIANGLES_NOT_JOINED', // above
  // rims, sheets, what is left out, budgets and levels have tests of their own
  'BASE_NOT_MADE', 'HIDDEN_DROPPED', 'LEVEL_FARTHER_THAN_ASKED', 'LEVEL_NOT_COARSER',
  'PIECES_DROPPED', 'RIMS_CLOSED',
  'RIMS_LEFT_OPEN', 'RIMS_NOT_KEPT', 'SHAPE_NOT_PREFERRED', 'SHEETS_MADE_BODIES',
  'SHEETS_NOT_MADE_BODIES', 'TOO_FEW_FACES',
  'IMAGES_NOT_FITTING', 'TEXCOORDS_REPLACED', 'TEXELS_NOT_FOUND', // tests/package/bake.test.js
  ...['ANGLES_TOO_SMALL', 'ATTRIBUTE_HAS_NO_CHARTS', 'ATTRIBUTE_NOT_CARRIED',
    'BACK_TO_BACK_TRIANGLES_REMOVED', 'BODIES_ALMOST_TOUCH', 'BODIES_OVERLAP',
    'CAVITIES_FILLED', 'COMMON_FACES_LEFT', 'COUNT_CONTRADICTS', 'CROSSINGS_LEFT',
    'DEGENERATE_TRIANGLES_MADE', 'DEGENERATE_TRIANGLES_REMOVED', 'DUPLICATE_TRIANGLES_REMOVED',
    'EXTENSION_NOT_CARRIED', 'FAULTS_NOT_SOUGHT',
    'GUIDES_FAR_AWAY', 'GUIDES_MIRRORED', 'GUIDES_NOT_KEPT', 'HIDDEN_BODIES_REMOVED',
    'HOLES_LEFT_OPEN',
    'INCONSISTENT_ORIENTATION_FIXED', 'INSTANCES_NOT_CONFORMED', 'ISOTROPIC_TAKES_MORE',
    'JOINTS_RELEASED',
    'JOINT_NOT_IN_SKIN', 'LEVELS_REPLACED',
    'MAP_NOT_PAINTED', 'MATERIALS_BY_NAME', 'MAX_ERROR_EXCEEDED', 'MORE_VERTICES_TAKEN',
    'NAME_CONTRADICTS', 'NEEDS_THINNING',
    'NON_FINITE_ATTRIBUTE',
    'NON_MANIFOLD_EDGES_LEFT', 'NON_MANIFOLD_EDGES_MADE', 'NON_MANIFOLD_EDGES_SPLIT',
    'NON_MANIFOLD_VERTICES_LEFT', 'NON_MANIFOLD_VERTICES_SPLIT',
    'NON_ORIENTABLE_CUT', 'NO_BODIES_TOUCH',
    'NOTHING_TO_REMESH', 'NOT_TRIANGLES', 'ONE_SIDED', 'ONLY_REPAIRED', 'PARTS_MERGED',
    'PASSED_ON', 'PLACES_JOINED', 'POLYGONS_CUT', 'QUADS_MADE_SYMMETRIC', 'QUADS_NUMBER_MISSED',
    'QUADS_OFF_BORDER', 'QUADS_PAIRED', 'QUADS_TURNED_AWAY',
    'QUADS_SYMMETRY_LOST', 'REMADE_IN_PART', 'SCRAPS_REMOVED',
    'SEEN_PARTS_LOST', 'SELF_INTERSECTIONS_MADE', 'SHAPE_LOST_TO_ROUNDING', 'SHAPE_TAKES_MORE',
    'SHEETS_DROPPED',
    'SHEETS_LEFT', 'SHEETS_THICKENED', 'SPIKES_LEFT_COARSE', 'SURFACE_OPENED',
    'TEXCOORDS_LEFT_OUT',
    'TEXTURES_PAINTED', 'THINNED_OUT', 'TOO_FEW_VERTICES', 'VERTICES_COINCIDE']];

test('what a message of each code advises is followed here, or it advises nothing', () => {
  const core = filesUnder('src', /\.cpp$/).map(readText).join('\n');
  const warnings = [...core.matchAll(/"([A-Z]+(?:_[A-Z]+)+)",\s*(?:\n\s*)?["a-zA-Z]/g)]
    .map(([, code]) => code);
  const known = new Set([...advice.map(([code]) => code), ...others]);
  assert.deepEqual([...new Set([...errorCodes, ...warnings])].filter((code) => !known.has(code)),
    []);
});

/** What is said of a code by the report of a run, or by its error. */
const wordsOf = ({ report, message, hint }, code) => (report
  ? report.warnings.filter((warning) => warning.code === code).map(({ message: words }) => words)
  : [message, hint]).join(' ');

for (const [code, provoke, expected, ...follow] of advice) {
  test(`${code}: to follow ${expected.source} helps`, async () => {
    const outcome = await provoke().catch((error) => error);
    assert.equal(outcome.code ?? code, code, outcome.message);
    const words = expected.exec(wordsOf(outcome, code));
    assert.ok(words, wordsOf(outcome, code));
    for (const run of follow) {
      const { report } = await run(words);
      assert.equal(wordsOf({ report }, code), '');
    }
  });
}
