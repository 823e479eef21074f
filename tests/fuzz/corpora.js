// SPDX-License-Identifier: MIT
// Makes the first inputs of the native fuzzers: small surfaces as files of every kind, and as the
// bytes that small_mesh.h reads. A target's words are keywords of its format.
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { dracoCompressed, meshoptCompressed } from '../support/compressed.js';
import { files, meshOf } from './made_files.js';
import { scans } from './made_scans.js';
import { shapes } from './made_shapes.js';

const chosen = ['tetrahedron', 'ball', 'sheet', 'moebius', 'book', 'pipe',
  'two boxes that touch along an edge'].map((name) => shapes[name](1));

const bytesOf = (text) => new TextEncoder().encode(text);
const joined = (...pieces) => new Uint8Array(Buffer.concat(pieces));
const zero = Uint8Array.of(0);

/** Every shape as each of these kinds. */
const made = (makers, ...kinds) => kinds.flatMap((kind) => chosen.map((shape) =>
  makers[kind](shape)));

const polygons = bytesOf(`mtllib made.mtl
v 0 0 0 1 0 0
v 1 0 0 0 1 0
v 1 1 0
v 0 1 0
v 0.5 0.5 1
vt 0 0
vt 1 0 0
vt 1 1
vn 0 0 1
o one
g a b
s 1
usemtl paint
f 1/1/1 2/2/1 3/3/1 4/1/1
f -1// -2// -3//
s off
f 1 2 5 \\
 4
l 1 2
p 1
`);

const gmshSquare = bytesOf(`$MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
1
2 3 "in let"
$EndPhysicalNames
$Entities
0 0 1 1
1 0 0 0 1 1 0 1 3 0
1 0 0 0 1 1 1 0 0
$EndEntities
$Nodes
1 5 1 9
2 1 0 5
1
2
3
4
9
0 0 0
1 0 0
1 1 0
0 1 0
0.5 0.5 1
$EndNodes
$Elements
3 4 1 4
2 1 3 1
1 1 2 3 4
2 1 2 2
2 1 2 9
3 2 3 9
3 1 4 1
4 1 2 3 9
$EndElements
`);

const gridArray = (type, name, values) =>
  `<DataArray type="${type}" Name="${name}" format="ascii">${values}</DataArray>`;
const vtuSquare = bytesOf(`<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" byte_order="LittleEndian" header_type="UInt32">
<UnstructuredGrid><FieldData>${gridArray('String', 'groupNames', '105 110 0')}</FieldData>
<Piece NumberOfPoints="5" NumberOfCells="4"><Points>
${gridArray('Float32', 'Points', '0 0 0 1 0 0 1 1 0 0 1 0 .5 .5 1')}</Points><Cells>
${gridArray('Int32', 'connectivity', '0 1 2 3 0 1 4 0 1 4 2 0 1 3 2')}
${gridArray('Int32', 'offsets', '4 7 11 15')}${gridArray('UInt8', 'types', '9 5 6 8')}</Cells>
<CellData>${gridArray('Int32', 'group', '0 0 0 0')}</CellData></Piece>
</UnstructuredGrid></VTKFile>`);

const packageModel = bytesOf(`<?xml version="1.0"?><model unit="inch"><resources>
<basematerials id="1"><base name="a &amp; b" displaycolor="#80808010"/></basematerials>
<object id="2" name="tip" pid="1" pindex="0"><mesh><vertices><vertex x="0" y="0" z="0"/>
<vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="0"/><vertex x="0" y="0" z="1e-3"/></vertices>
<triangles><triangle v1="0" v2="2" v3="1" pid="1" p1="0"/><triangle v1="0" v2="1" v3="3"/>
</triangles></mesh></object><object id="3"><components><component objectid="2"
transform="0 1 0 -1 0 0 0 0 1 5 0 0"/><component objectid="3"/></components></object></resources>
<build><item objectid="3"/><item objectid="2" transform="1 0 0 0 1 0 0 0 1 0 0 7"/></build>
</model>`);

const listedTexcoords = bytesOf(`ply
format ascii 1.0
comment TextureFile made.png
element vertex 4
property double x
property double y
property double z
property uchar red
property uchar green
property uchar blue
property uchar alpha
property float quality
element face 2
property list uchar int vertex_indices
property list uchar float texcoord
property int texnumber
element edge 1
property int vertex1
property int vertex2
end_header
0 0 0 255 0 0 255 1
1 0 0 0 255 0 255 1
1 1 0 0 0 255 255 1
0 1 0 9 9 9 255 1
4 0 1 2 3 8 0 0 1 0 1 1 0 1 0
3 0 2 3 6 0 0 1 1 0 1 0
0 1
`);

const strips = bytesOf(`ply
format ascii 1.0
element vertex 4
property float x
property float y
property float z
element tristrips 1
property list int int vertex_indices
end_header
0 0 0
1 0 0
0 1 0
1 1 1
6 0 1 2 3 -1 0
`);

const solids = bytesOf(`solid one
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 1 0 0
vertex 0 1 0
endloop
endfacet
endsolid one
solid two
facet normal 0 0 1
outer loop
vertex 0 0 1
vertex 1 0 1
vertex 0 1 1
endloop
endfacet
endsolid two
`);

const coloredFaces = bytesOf(`COFF
# made
5 3 0
0 0 0 255 0 0 255
1 0 0 0 255 0 255
1 1 0 0 0 255 255
0 1 0 0.5 0.5 0.5 1
0.5 0.5 1 1 1 1 1
4 0 1 2 3
3 0 1 4 255 0 0
3 1 2 4 0.5 0 0
`);

const beside = (file) => joined(file.bytes, zero, file.resources?.['made.bin'] ?? zero);

function meshBytes({ positions, triangles }) {
  const count = Math.min(positions.length, 64);
  const numbers = Float32Array.from(positions.slice(0, count).flat());
  return joined(Uint8Array.of(count - 1), new Uint8Array(numbers.buffer),
    Uint8Array.from(triangles.flat()));
}

/** The options of remesh.cpp, byte for byte: target, scheme, numbers, extras. */
const optionBytes = [[2, 20, 0, 3, 0, 0, 0, 0, 0], [2, 60, 1, 0, 0, 0, 0, 0, 7],
  [1, 120, 2, 1, 99, 0, 60, 0, 8], [2, 40, 8, 2, 0, 9, 0, 63, 2], [0, 0, 20, 3, 200, 0, 0, 0, 1]];

/** The options of repair.cpp, byte for byte: kind, flags, extras, formats given and asked for. */
const repairBytes = [[0, 0, 15, 0, 0], [1, 4, 3, 1, 2], [2, 1, 15, 2, 0], [3, 2, 7, 0, 1],
  [0, 16, 1, 0, 0]];

async function compressed() {
  const shape = shapes.ball(1);
  const { positions, indices, attributes } = meshOf(shape);
  return [await meshoptCompressed(files.textured(shape)),
    await dracoCompressed({ positions, indices, texcoords: attributes.TEXCOORD_0.array })];
}

/** For each target: the inputs, their greatest length while fuzzing, and words of the format. */
export async function makeCorpora() {
  const contents = (list) => list.map(({ bytes }) => bytes);
  const gltfWords = ['POSITION', 'NORMAL', 'TEXCOORD_0', 'JOINTS_0', 'WEIGHTS_0', 'sparse',
    'KHR_mesh_quantization', 'KHR_texture_transform', 'byteStride', 'normalized', 'targets'];
  return {
    glb: { length: 8192, words: gltfWords, inputs: contents([...await compressed(),
      ...made(files, 'plain', 'textured', 'quantized', 'skinned', 'sparse', 'morphing',
        'instanced')]) },
    gltf: { length: 8192, words: gltfWords,
      inputs: made(files, 'beside', 'embedded').map(beside) },
    obj: { length: 2048, words: ['mtllib ', 'usemtl ', 'vt ', 'vn ', 'f ', 'g ', 's off', '//'],
      inputs: [polygons, ...made(files, 'obj').map((file) =>
        joined(file.bytes, zero, file.resources['made.mtl']))] },
    off: { length: 2048, words: ['STCNOFF', 'nOFF', 'BINARY', 'NOFF', 'CNOFF'],
      inputs: [coloredFaces, ...contents(made(files, 'off', 'off with colours'))] },
    ply: { length: 4096, words: ['property list uchar int ', 'property double ', 'element face ',
      'binary_little_endian', 'binary_big_endian', 'obj_info ', 'texcoord', 'multi_texture_vertex'],
    inputs: [listedTexcoords, strips,
      ...contents(made(scans, 'ply', 'ply in text', 'ply of the other order'))] },
    stl: { length: 4096, words: ['solid', 'facet normal', 'outer loop', 'COLOR=', 'endfacet'],
      inputs: [solids, ...contents(made(scans, 'stl', 'stl in text'))] },
    msh: { length: 2048, words: ['$Nodes', '$Elements', '$Entities', '$PhysicalNames', '2.2 0 8'],
      inputs: [gmshSquare] },
    vtu: { length: 4096, words: ['format="binary"', 'format="appended" offset="0"', 'UInt64',
      '<AppendedData encoding="raw">_', 'compressor', 'PolyData', 'Polys'], inputs: [vtuSquare] },
    '3mf': { length: 4096, words: ['<colorgroup id="4">', '<color color="#FF0000"/>', 'p:path=',
      '<component objectid=', '<![CDATA['], inputs: [packageModel] },
    builder: { length: 4096, words: [], inputs: chosen.map(meshBytes) },
    remesh: { length: 1200, words: [], inputs: chosen.flatMap((shape) => optionBytes.map((bytes) =>
      joined(Uint8Array.from(bytes), meshBytes(shape)))) },
    repair: { length: 1200, words: [], inputs: chosen.flatMap((shape) => repairBytes.map((bytes) =>
      joined(Uint8Array.from(bytes), meshBytes(shape)))) },
  };
}

/** Writes each input of a target to a file in a folder. @returns {string[]} their paths */
export function writeInputs(folder, inputs) {
  mkdirSync(folder, { recursive: true });
  return inputs.map((bytes, i) => {
    const path = join(folder, `seed-${String(i).padStart(3, '0')}`);
    writeFileSync(path, bytes);
    return path;
  });
}
