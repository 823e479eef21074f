// SPDX-License-Identifier: MIT
// Dials are the algorithm's named constants that somebody chose. Each dial needs evidence, so their
// number may only fall. A constant that nobody chose is a fact.
import { filesUnder, readText } from './tree.js';

/** The rooms of src that are the algorithm, and the most dials that they may have together. */
export const algorithm = ['mesh', 'geometry', 'original', 'remesh', 'simplify', 'textures'];
export const mostDials = 205;

/**
 * Named constants that are no dials, by file. They are bounds of rounding, marks for what a value
 * cannot be, sizes of types and tables, what the report, a format or a dial determines, and what
 * only progress or a message shows.
 * @type {Record<string, string[]>}
 */
export const facts = {
  'geometry/fast_trigonometry.h': ['kTanEighth'],
  'geometry/piecewise.cpp': ['kManyCorners'],
  'geometry/piecewise.h': ['kMostCorners'],
  'geometry/predicates.cpp': ['kHalfUlp', 'kOrient2dError', 'kOrient3dError', 'kSplitter'],
  'geometry/triangle.cpp': ['kThin'],
  'geometry/triangle.h': ['kFlattest'],
  'geometry/triangle_tree.cpp': ['kMost'],
  'geometry/triangle_tree.h': ['kDeepest'],
  'mesh/joining.cpp': ['kMostCells', 'kSingleNoise', 'kDoubleNoise', 'kPercents'],
  'mesh/space_order.cpp': ['kCells', 'kBits'],
  'original/curves/flat_regions.cpp': ['kSharp'],
  'original/curves/seams.cpp': ['kQuantum'],
  'original/curves/spikes.cpp': ['kWorthAWord', 'kBuckets'],
  'original/patches/disk_parameterization.cpp': ['kUnnumbered'],
  'original/patches/disk_patch.cpp': ['kSpared', 'kTrimmable'],
  'original/patches/disk_patch.h': ['kNoLocal', 'kMaxFaces'],
  'original/patches/point_location.cpp': ['kInside'],
  'original/patches/point_location.h': ['kHashFactor'],
  'original/surface/size_field.cpp': ['kDigits', 'kBits'],
  'original/surface/size_field.h': ['kLong', 'kShort'],
  'remesh/accuracy/fit.cpp': ['kAtCorner', 'kAtMiddle'],
  'remesh/accuracy/star_search.cpp': ['kAlongNormal'],
  'remesh/gate/angles.cpp': ['kSurely'],
  'remesh/gate/fidelity.cpp': ['kLine', 'kPlain', 'kPlainGrains'],
  'remesh/operators/local_change.h': ['kMoved'],
  'remesh/quads/extract/extraction.cpp': ['kHalf'],
  'remesh/quads/field/cross_field.cpp': ['kOpposed'],
  'remesh/quads/field/face_frames.cpp': ['kOfHalves'],
  'remesh/quads/map/seamless_map.h': ['kUnit', 'kLongest'],
  'remesh/quads/map/untangle.cpp': ['kDifference'],
  'remesh/quads/mesh/triangulated.cpp': ['kOfSide'],
  'remesh/quads/quads.cpp': ['kFewestOfPairs'],
  'remesh/schemes/chart_needs.cpp': ['kEverySize'],
  'remesh/schemes/follow.cpp': ['kFar', 'kNear'],
  'remesh/schemes/plan.cpp': ['kWritten'],
  'remesh/schemes/remesh.cpp':
    ['kHalfUlp', 'kHalfLeast', 'kBoundShare', 'kRoundsShare', 'kMapShare'],
  'remesh/schemes/rounds.cpp': ['kAreaSweeps', 'kAreaRounds', 'kLaplacianRounds', 'kGradingShare'],
  'remesh/schemes/targets.cpp': ['kFewestVertices', 'kAddresses', 'kDigits'],
  'remesh/steps/boundaries.cpp': ['kLargest'],
  'remesh/steps/coarsen.cpp': ['kTick', 'kPassShare'],
  'remesh/steps/lengths.h': ['kUnknown'],
  'remesh/steps/polish.cpp': ['kMeansByTurns'],
  'remesh/steps/relax.cpp': ['kNeighbors'],
  'remesh/steps/valence.cpp': ['kSeed'],
  'remesh/transfer/attribute_mix.cpp': ['kInfluences'],
  'simplify/simplify.cpp': ['kSharp'],
  'textures/charts/chart_growth.cpp': ['kLeastCosine'],
  'textures/charts/chart_packing.cpp': ['kBits', 'kWords', 'kAll'],
  'textures/charts/chart_relaxing.cpp': ['kMostArea', 'kLeastArea', 'kMostStretch'],
  'textures/painting/canvas.cpp': ['kReach', 'kColumns', 'kRows', 'kPair'],
  'textures/painting/paint_source_setup.cpp': ['kTexcoordSets'],
  'textures/painting/shading.cpp': ['kHard'],
  'textures/painting/side_finder.cpp': ['kEdge'],
  'textures/painting/texture.cpp': ['kSteps'],
};

/** The named constants that a C++ text defines. @param {string} text @returns {string[]} */
export function constantsIn(text) {
  const code = text.replace(/\/\/.*$/gm, '');
  const statements = code.matchAll(
    /\b(?:constexpr|const (?:double|float))\b[^;{()]*\bk[A-Z]\w*\s*(?:=|\{)[^;]*;/g);
  return [...statements].flatMap(([statement]) =>
    [...statement.matchAll(/\b(k[A-Z]\w*)\s*(?:=(?!=)|\{)/g)].map(([, name]) => name));
}

/** The dials of each room of the algorithm. @returns {[string, number][]} */
export function dialsOfRooms() {
  const dialsIn = (/** @type {string} */ file) => {
    const known = facts[file.replace('src/', '')] ?? [];
    return constantsIn(readText(file)).filter((name) => !known.includes(name)).length;
  };
  return algorithm.map((room) => [room, filesUnder(`src/${room}`, /\.(h|cpp)$/)
    .reduce((sum, file) => sum + dialsIn(file), 0)]);
}
