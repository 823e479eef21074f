// SPDX-License-Identifier: MIT
// The types of messages: a job goes to an engine, in this thread or in a worker; an outcome comes
// back. Every message survives structured cloning.

/** @import { Failure } from './errors.js' */

/** @typedef {Float32Array | Float64Array} Floats */
/** @typedef {Uint32Array | Uint16Array} Indices */
/**
 * @typedef {Float32Array | Float64Array | Int8Array | Uint8Array | Uint8ClampedArray | Int16Array
 *   | Uint16Array | Int32Array | Uint32Array} NumberArray
 */

/**
 * Per-vertex values of one glTF semantic: NORMAL, TEXCOORD_0, COLOR_0, JOINTS_0, …
 * @typedef {object} MeshAttribute
 * @property {NumberArray} array `itemSize` values for each vertex.
 * @property {number} itemSize How many values a vertex has.
 */

/**
 * @typedef {object} Mesh
 * @property {Floats} positions Three coordinates for each vertex.
 * @property {Indices} indices Three vertices for each triangle, counterclockwise from outside.
 * @property {Record<string, MeshAttribute>} [attributes] Per-vertex values, by glTF semantic;
 *   those of a morph target begin with its number: `TARGET_0/POSITION`.
 * @property {Indices} [groups] One number for each triangle: a material, for instance. Borders
 *   between groups are kept as curves.
 * @property {Indices} [quads] In a result of quads: four vertices for each quad,
 *   counterclockwise, in the order of the triangles; each quad is two triangles.
 */

/**
 * A mesh of a scene.
 * @typedef {object} PlacedMesh
 * @property {Mesh} mesh In its own space.
 * @property {ArrayLike<number>[]} [places] One transform from its own space to the world for
 *   each place where the scene shows it: matrices of 16 numbers, column after column.
 * @property {ArrayLike<number>} [finer] Numbers of the scene's meshes that this mesh stands for
 *   from afar. Such a coarser level of detail keeps its proportion to them, and the report leaves
 *   it out.
 */

/**
 * @typedef {object} NamedBytes
 * @property {string} name The file's name.
 * @property {Uint8Array} bytes Its contents.
 */

/**
 * Which engine: the small one, which takes arrays only, or the whole one.
 * @typedef {'arrays' | 'whole'} EngineName
 */

/** @typedef {{ engine: EngineName, module: WebAssembly.Module }} Loaded */

/**
 * A request to an engine.
 * @typedef {{ kind: 'remesh', parts: PlacedMesh[], options: Record<string, unknown> }
 *   | { kind: 'remeshFile', file: FileRequest, options: Record<string, unknown> }
 *   | { kind: 'repair', parts: PlacedMesh[], options: Record<string, unknown> }
 *   | { kind: 'repairFile', file: FileRequest, options: Record<string, unknown> }
 *   | { kind: 'boolean', operands: [Mesh, Mesh], operation: BooleanOperation }
 *   | { kind: 'booleanFiles', files: [FileRequest, FileRequest], operation: BooleanOperation }
 *   | { kind: 'bake', meshes: [Mesh, Mesh], options: Record<string, unknown> }
 *   | { kind: 'bakeFile', files: [FileRequest, FileRequest], options: Record<string, unknown> }
 *   | { kind: 'unwrap', mesh: Mesh, options: Record<string, unknown> }
 *   | { kind: 'unwrapFile', file: FileRequest, options: Record<string, unknown> }
 *   | { kind: 'convertFile', file: FileRequest, options: Record<string, unknown> }
 *   | { kind: 'inspect', mesh: Mesh, closely?: { faults: boolean, edges: boolean } }
 *   | { kind: 'inspectFile', file: FileRequest, faults?: boolean }} Job
 */

/**
 * Both bodies as one; the first without the second; what both have in common.
 * @typedef {'union' | 'subtract' | 'intersect'} BooleanOperation
 */

/**
 * A decoded image: four bytes per texel, row after row from the top.
 * @typedef {object} Picture
 * @property {string} name Its name in the file that it belongs to.
 * @property {string} type The type that it is to be encoded as.
 * @property {number} width Texels.
 * @property {number} height Texels.
 * @property {Uint8Array} texels The bytes.
 * @property {number} [lowered] By how much its quality is lower than usual.
 */

/**
 * A file; `bytes` are the first ones if it is read in blocks: by its handle, in the worker by
 * `blocks`. A glTF made of it is not to be scaled to metres where `isInMetres` is false.
 * @typedef {NamedBytes & { resources: NamedBytes[], output: string, isInMetres?: boolean,
 *   pictures?: Picture[],
 *   handle?: import('./open_file.js').FileHandle,
 *   blocks?: { size: number, read: import('./open_file.js').ReadBlock } }} FileRequest
 */

/**
 * @typedef {object} ProgressEvent
 * @property {string} phase The present step of the run.
 * @property {number} fraction How far the whole run is, from 0 to 1.
 */

/**
 * To the worker: first the compiled module, then jobs, one at a time. A second module replaces
 * the first.
 * @typedef {Loaded & { type: 'start', helpers: number }
 *   | { type: 'job', job: Job, progress: boolean }} ToWorker
 */

/**
 * From the worker: any number of progress events, then one outcome for each job.
 * @typedef {{ type: 'progress', event: ProgressEvent }
 *   | { type: 'done', result: any }
 *   | { type: 'failed', failure: Failure }} FromWorker
 */

/**
 * To a worker for images, and back; an image as ImageCodecs takes it.
 * @typedef {{ work: 'decode' | 'encode', image: any }} ImageJob
 * @typedef {{ result: any } | { failure: Failure }} ImageAnswer
 */

/**
 * A worker for images.
 * @typedef {object} ImagePort
 * @property {(job: ImageJob, transfer: ArrayBuffer[]) => void} post
 * @property {(onAnswer: (answer: ImageAnswer) => void, onFailure: () => void) => void} listen
 * @property {() => void} terminate
 */

/**
 * The smallest angle of each triangle.
 * @typedef {object} MinAngle
 * @property {number} worst Degrees.
 * @property {number} mean Degrees.
 * @property {number[]} histogram Percent of the triangles in 0–10, 10–20 … 50–60 degrees.
 */

/**
 * @typedef {object} MeshReport
 * @property {number} vertices Distinct positions.
 * @property {number} triangles How many there are.
 * @property {number} components Connected pieces.
 * @property {number} boundaryEdges Edges of one triangle only.
 * @property {number} nonManifoldEdges Edges of more than two triangles.
 * @property {number} eulerCharacteristic Vertices − edges + triangles.
 * @property {number} degenerateTriangles Triangles without an area.
 * @property {MinAngle} minAngle The smallest angle of each triangle.
 * @property {number} maxAngle The largest angle of all, degrees.
 * @property {number} valence6 Percent of the interior vertices with six neighbours.
 * @property {QuadReport} [quads] Only for a mesh of quads alone.
 * @property {Wanted} [wanted] Of a result, if `minEdge`, `maxEdge` or `minAngle` was given;
 *   `edgeLength` with `minAngle` limits edges, too.
 */

/**
 * What came of a limit of every edge or triangle, measured on the result as it is written.
 * @typedef {object} WantedFigure
 * @property {number} asked The limit: a length in the world’s units, or degrees.
 * @property {number} worst The shortest or longest edge, or the smallest angle.
 * @property {number} missed Edges or triangles that do not keep it.
 * @property {number} kept Percent of the edges or triangles that do.
 * @property {[number, number, number]} [at] The place of the worst, if any does not.
 */

/**
 * @typedef {object} Wanted
 * @property {WantedFigure} [minEdge] If it was given.
 * @property {WantedFigure} [maxEdge] If it was given.
 * @property {WantedFigure} [minAngle] If it was given.
 */

/**
 * How good quads are.
 * @typedef {object} QuadReport
 * @property {number} count How many there are.
 * @property {number} irregular Interior vertices whose valence is not 4.
 * @property {{ mean: number, p95: number, worst: number }} angleDeviation |angle − 90°| of all
 *   corners, degrees; 95 % of them are within p95.
 * @property {{ min: number, mean: number }} scaledJacobian The sine of the angle at each quad’s
 *   worst corner: 1 in a square, negative in a fold.
 * @property {number} edgeVariation The standard deviation of the edges’ lengths over their mean.
 * @property {number} symmetry Of a result: the planes about which quads were made their own mirror
 *   images, at most three of each mesh, in all meshes together.
 * @property {{ count: number, longest: number, selfCrossing: number }} loops Loops of quads go from
 *   each quad to the one across the opposite side: how many there are; percent of all edges that
 *   the longest crosses; percent of the quads in which a loop crosses itself.
 * @property {number} parts Of a result: connected parts.
 * @property {{ at: [number, number, number], quads: number }[]} paired Of a result: the connected
 *   parts for which no map to squares was found, each with a place and its number of quads, which
 *   are divided pairs of triangles.
 */

/**
 * A message to the caller of a run that did not fail.
 * @typedef {object} Warning
 * @property {string} code For programs.
 * @property {string} message For people.
 * @property {number} count How many there are.
 * @property {'note' | 'loss' | 'fault'} [severity] A note says how something was done; a loss, what
 *   of the input or of the request the result lacks; a fault, what is wrong with the result.
 * @property {[number, number, number]} [at] The place of the first or the worst of them, if it has
 *   one, in the world of the file.
 */

/**
 * @typedef {object} Timings
 * @property {number} read Milliseconds.
 * @property {number} build Milliseconds.
 * @property {number} remesh Milliseconds.
 * @property {number} write Milliseconds.
 */

/**
 * @typedef {object} Phase
 * @property {string} name Its name, as in progress events.
 * @property {number} milliseconds How long it took.
 */

/**
 * @typedef {object} Memory
 * @property {number} peakBytes The most memory that WebAssembly held, in this run or in an earlier
 *   one that left up to 64 MiB for the next.
 */

/**
 * @typedef {object} Inspection
 * @property {string} version The version of remesher.
 * @property {MeshReport} input The mesh as it came.
 * @property {number} diagonal Of the bounding box of what came, in model units.
 * @property {string} [unit] What lengths are in: `mm`, `cm`, `m`, `in`, as was said or by the file;
 *   of 3MF `µm` and `ft` too. Unknown without it.
 * @property {Timings} timings How long the steps took.
 * @property {Memory} memory How much memory the run took.
 * @property {Phase[]} phases All phases of the run, in order.
 * @property {Warning[]} warnings Repairs and losses while reading.
 * @property {Texture[]} [textures] The images of a glTF file: of what was inspected, or of the
 *   result.
 * @property {FaultSummary} [faults] What is broken, if the inspection was asked for it and memory
 *   had room for the search; else the warning `FAULTS_NOT_SOUGHT` says why.
 * @property {EdgeSummary} [edges] The edges by kind, if the inspection was asked for them.
 */

/**
 * An image of a glTF file.
 * @typedef {object} Texture
 * @property {string} name Its own, its file's, or its number.
 * @property {string} type Such as `image/png`.
 * @property {number} [width] Texels, if its header says so.
 * @property {number} [height] Texels.
 * @property {number} bytes Its size in the file.
 */

/**
 * The edges of a mesh by kind: two vertices for each edge, of those at one place the first.
 * @typedef {object} EdgeSummary
 * @property {Uint32Array} boundary Edges of one triangle.
 * @property {Uint32Array} nonManifold Edges of more than two.
 * @property {Uint32Array} flipped Edges of two triangles that face opposite ways.
 * @property {Uint32Array} bent Edges of two triangles that bend there by 5 degrees at least, those
 *   that bend most first.
 * @property {Float64Array} bends The degrees by which these bend.
 * @property {Uint32Array} first For each vertex the first at its place.
 */

/**
 * The faults of a mesh, and the repair that would mend them.
 * @typedef {object} FaultSummary
 * @property {number[]} openLoops The lengths of open boundaries, in percent of the bounding box's
 *   diagonal, as `holesUpTo` takes them; the longest first.
 * @property {number} selfIntersections Triangles that meet others.
 * @property {number} innerShells Closed pieces within others that are no cavities.
 * @property {number} insideOut Pieces that face inwards, and open ones that would, once closed.
 * @property {'off' | 'holes' | 'solid' | 'wrap'} repair The repair that `auto` would choose; `off`:
 *   nothing is broken, or there are only sheets, which it leaves as they are.
 * @property {RepairNeeds} needs The needs of that repair, before it begins. Approximate.
 * @property {FaultPlaces} places Where it is broken.
 */

/**
 * The time and memory that a repair takes.
 * @typedef {object} RepairNeeds
 * @property {number} bytes The most memory that it holds.
 * @property {number} seconds The time of one core.
 */

/**
 * Where a mesh is broken: coordinates in the file's world, three for each place.
 * @typedef {object} FaultPlaces
 * @property {number[]} openLoops A vertex of each open loop, in their order.
 * @property {number[]} selfIntersections Per mesh with any, the middle of the first triangle that
 *   meets others.
 * @property {number[]} innerShells A vertex of each inner shell.
 * @property {number[]} insideOut A vertex of each piece that is inside out.
 */

/**
 * Distances between result and original, in percent of the diagonal of the original's bounding box.
 * @typedef {object} Distances
 * @property {number} hausdorff The largest distance that samples of both surfaces find.
 * @property {number} rms Root mean square.
 */

/** @typedef {'even' | 'shape'} Preferred */

/**
 * Why the result is the mesh that it is: the row of the chooser's table that took it.
 * @typedef {object} Chosen
 * @property {string} rule The row's name, such as `simplified-nearer`.
 * @property {string} reason A sentence.
 */

/**
 * @typedef {object} RunReport
 * @property {MeshReport} output The resulting mesh.
 * @property {Distances} fidelity How far result and original are apart.
 * @property {'target' | 'fidelity' | 'max-error' | 'cancelled'} stopped What ended the run.
 * @property {Preferred | Preferred[]} prefer Whether the result has isotropic triangles (`even`) or
 *   is the simplified original (`shape`); a list for the meshes if they differ.
 * @property {Chosen | Chosen[]} chosen Why this result was taken; a list for the meshes if they
 *   differ.
 */

/**
 * @typedef {object} SizedPlace
 * @property {number[]} at The middle: three coordinates.
 * @property {number} across Twice the largest distance from there, in model units.
 */

/**
 * The pieces left out on request.
 * @typedef {object} DropSummary
 * @property {number} pieces Pieces smaller than asked for.
 * @property {number} hidden Triangles that nobody sees from outside.
 * @property {number} lost Both together, in percent of the area.
 * @property {SizedPlace[]} piecesAt Some of the pieces, the largest first.
 * @property {number[]} hiddenAt A corner of some of the triangles, three coordinates each.
 */

/**
 * The outcome of a repair.
 * @typedef {object} RepairSummary
 * @property {string} mode How the mesh was repaired.
 * @property {'asked' | 'sound' | 'joined' | 'closed' | 'united' | 'made' | 'sheets' | 'partly'
 *   | 'enclosed' | 'open'} reason Why in that mode: it was asked for; nothing was wrong, and the
 *   mesh is unchanged; only nearly equal places were made one; the surface is sound once its loops
 *   are closed; bodies that intersect were united exactly; sheets became bodies; sheets,
 *   which enclose nothing, were left; a lattice remade only what has no exact outside; a lattice
 *   found bodies; a lattice found the outside.
 * @property {number} holes Open loops closed.
 * @property {number} islands Small open components removed.
 * @property {number} shells Bodies inside others, removed because nobody sees them.
 * @property {number} turned Triangles turned over.
 * @property {number} rims Openings that look intended, left open.
 * @property {number} bodies Sheets that became bodies.
 * @property {SizedPlace[]} closedAt Some of the loops closed, the widest first.
 * @property {SizedPlace[]} rimsAt Some of those rims, likewise.
 * @property {number} lost Percent of the area that the result lacks: of what is seen from outside,
 *   what is farther from the result than `lostBeyond`. Where only holes are closed, of all.
 * @property {number} lostBeyond In percent of the diagonal; 0 where only holes are closed.
 * @property {number[]} lostAt A few places of it, three coordinates each, the farthest first.
 * @property {number[]} selfIntersections Triangles that meet others, before and after repair.
 */

/**
 * `chosen` says whether the mesh was kept or repaired.
 * @typedef {Inspection & { output: MeshReport, repair: RepairSummary, dropped?: DropSummary,
 *   compression?: Compression, chosen: Chosen | Chosen[], card?: Card }}
 *   RepairReport
 */

/**
 * How a Boolean came about.
 * @typedef {object} BooleanSummary
 * @property {BooleanOperation} operation The operation asked for.
 * @property {number} cut Triangles of both operands that met others.
 * @property {number} selfIntersections Triangles of the result that meet others, by rounding.
 */

/**
 * The input's figures are those of both operands. `repair` says what was mended first, if anything.
 * @typedef {Inspection & { output: MeshReport, boolean: BooleanSummary, repair?: RepairSummary }}
 *   BooleanReport
 */

/**
 * Faces that closed bodies have in common, with `conform`.
 * @typedef {object} ConformSummary
 * @property {number} faces Connected faces, of two bodies each.
 * @property {number} triangles Their triangles, each counted once.
 * @property {number} area Their area, in the world’s units.
 */

/**
 * Texture coordinates, and the maps that were painted for them.
 * @typedef {object} AtlasSummary
 * @property {number} size Texels along a side of the square.
 * @property {number} charts Pieces that texture coordinates connect.
 * @property {boolean} given Whether they are the mesh’s own.
 * @property {number} coverage Percent of the square.
 * @property {number} stretch The root mean square of lengths on the surface per length in the
 *   square, over that of a map that is even everywhere: 1 is best.
 * @property {number} worstStretch The largest of them.
 * @property {number} [cage] Of baking: how far the other surface was looked for, percent of its
 *   diagonal.
 * @property {number} [notFound] Of baking: percent of the texels for which nothing was found.
 */

/**
 * `input` is the mesh onto which was baked, or which was unwrapped.
 * @typedef {Inspection & { output: MeshReport, atlas: AtlasSummary }} AtlasReport
 */

/**
 * How the written glTF was compressed.
 * @typedef {object} Compression
 * @property {'meshopt' | 'draco'} method As was asked for.
 * @property {number} before Bytes of all files without it.
 * @property {number} after Bytes of all files.
 * @property {number} error The farthest that rounding moves a position, in percent of its mesh's
 *   diagonal.
 */

/**
 * When a level of detail may be shown instead of the finer one: its largest distance is then seen
 * as one pixel of 1080.
 * @typedef {object} Switch
 * @property {number} coverage The share of a screen of 1920 × 1080 that the disk around the model
 *   covers, as `MSFT_screencoverage` has it.
 * @property {number} distance The camera's from the model, in model units, at an upright angle of
 *   view of 50 degrees: for `LOD.addLevel` of three.js.
 */

/**
 * The languages of a report card.
 * @typedef {'en' | 'de' | 'fr'} CardLanguage
 */

/**
 * One side of a report card.
 * @typedef {object} CardSide
 * @property {number} bytes Of the file and of those that it refers to.
 * @property {number} triangles Two for each quad.
 * @property {number} [quads] Quads, if there are any.
 * @property {number} vertices Distinct positions.
 * @property {number} pieces Connected components.
 * @property {boolean} closed Whether no edge has a triangle on one side only.
 * @property {number} openEdges Edges that have.
 * @property {number} nonManifoldEdges Edges of more than two triangles.
 * @property {number} [selfIntersections] Triangles that meet others, where a repair looked for
 *   them.
 */

/**
 * A run of a file in a few figures, before and after. `remesher/card` has it in words.
 * @typedef {object} Card
 * @property {CardSide} before The model as read.
 * @property {CardSide} after The model as written; of levels of detail the finest, and the bytes of
 *   all.
 * @property {{ percent: number, length: number, unit?: string }} [distance] The largest distance
 *   between them, in percent of the original's diagonal and in the model's unit; not known after a
 *   repair alone that changed something.
 * @property {number} [hidden] Triangles left out because nobody sees them, if that was asked for.
 * @property {number} [coverage] Percent of the square that the charts of new textures cover.
 */

/**
 * The options that a preset stood for, by their names.
 * @typedef {Record<string, string | number | boolean>} PresetOptions
 */

/**
 * @typedef {Inspection & RunReport & { preset?: PresetOptions, repair?: RepairSummary,
 *   dropped?: DropSummary, conform?: ConformSummary, takesOver?: Switch,
 *   compression?: Compression, lods?: RemeshReport[], card?: Card }} RemeshReport
 */

export {};
