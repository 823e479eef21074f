// SPDX-License-Identifier: MIT
#include "remesh/schemes/mirrored.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/place.h"
#include "geometry/extent.h"
#include "geometry/triangle_tree.h"
#include "remesh/operators/projection.h"
#include "remesh/quads/quads.h"
#include "remesh/schemes/curve_choice.h"
#include "remesh/schemes/number_note.h"
#include "remesh/schemes/targets.h"
#include "remesh/symmetry/joined.h"
#include "remesh/symmetry/mirror_planes.h"

namespace remesher {

namespace {

// What the caller painted, marked or keeps may lie on one side only.
bool mayMirror(const RemeshOptions& options) {
  return options.quads && options.symmetry == Symmetry::Auto && options.mirrors.planes.empty() &&
         options.density.empty() && options.featureEdges.empty() &&
         options.boundary == Boundary::Resample;
}

// Whether the middle of each seam comes to a seam.
bool areMirrored(const std::vector<Halfedge>& seams, const BuiltMesh& built,
                 const MirrorPlane& plane, double tolerance) {
  if (seams.empty()) return true;
  std::vector<Index> lines;
  for (const Halfedge h : seams) {
    const Index from = built.mesh.origin(h).index, to = built.mesh.tip(h).index;
    lines.insert(lines.end(), {from, to, to});
  }
  const TriangleTree tree(built.positions.values(), lines);
  return std::all_of(seams.begin(), seams.end(), [&](Halfedge h) {
    const Vec3 ends = built.positions[built.mesh.origin(h)] + built.positions[built.mesh.tip(h)];
    return tree.nearest(plane.mirrored(ends / 2)).squaredDistance <= tolerance * tolerance;
  });
}

// Quads of the half that these planes cut off, joined with their images.
std::optional<RemeshOutcome> mirroredBy(const Mirrors& mirrors, const InputAttributes& whole,
                                        RemeshOptions options, const HalfRemesher& remeshHalf) {
  std::optional<Half> half = inFrontOf(mirrors, whole.input());
  if (!half) return {};
  for (const Attribute& attribute : whole.input().attributes)
    half->mesh.attributes.push_back({attribute.semantic, attribute.itemSize, {}});
  for (const InputPlace& place : half->vertices) whole.append(place, half->mesh.attributes);
  options.vertices = Index(mirrors.vertices >> mirrors.planes.size());
  options.ratio.reset();
  options.edgeLength.reset();
  options.tooFew = TooFew::Raise;
  options.mirrors = mirrors;
  RemeshOutcome made = remeshHalf(half->mesh, options);
  if (made.stopped != Stopped::Target) return {};
  std::optional<PlacedQuads> joined =
      joinedImages({std::move(made.mesh), std::move(made.places)}, *half, mirrors, whole);
  if (!joined) return {};
  made.mesh = std::move(joined->mesh);
  made.places.clear();
  if (options.textures == Textures::Bake) made.places = std::move(joined->places);
  made.vertices = countPlaces(made.mesh.positions);
  noteNumber(made, {mirrors.vertices, options.exact});
  made.mirrors = mirrors.planes.size();
  return made;
}

}  // namespace

std::optional<RemeshOutcome> remeshMirrored(const TriangleMesh& input, const RemeshOptions& options,
                                            const HalfRemesher& remeshHalf) {
  if (!mayMirror(options)) return {};
  const Extent extent = extentOf(input);
  const double wished = options.vertices.value_or(Index(input.positions.size()));
  // The triangles of smooth models are seldom mirrored exactly.
  const double tolerance = kPlainlyNear * evenEdgeLength(extent.area, wished);
  Mirrors mirrors{findMirrorPlanes(input, tolerance), kSingleRoundOff * extent.diagonal()};
  if (mirrors.planes.empty()) return {};
  BuiltMesh built = buildMesh(input);
  mirrors.vertices = targetVertices(built, options);
  std::vector<std::string> chartless;
  if (!input.attributes.empty() || !input.groups.empty()) {
    const double size = evenEdgeLength(surfaceArea(built), double(mirrors.vertices));
    CurveCandidates candidates = curveCandidates(built, input, options, size);
    std::erase_if(mirrors.planes, [&](const MirrorPlane& plane) {
      return !areMirrored(candidates.seams.edges, built, plane, tolerance) ||
             !areMirrored(candidates.seams.borders, built, plane, tolerance);
    });
    chartless = std::move(candidates.seams.chartless);
  }
  const InputAttributes whole(input, std::move(built), std::move(chartless));
  // Fewer planes may come nearer to the number; else as many as can be are kept.
  std::optional<RemeshOutcome> best;
  for (; !mirrors.planes.empty(); mirrors.planes.pop_back()) {
    std::optional<RemeshOutcome> outcome = mirroredBy(mirrors, whole, options, remeshHalf);
    if (!outcome) continue;
    if (isMet(outcome->vertices, {mirrors.vertices, options.exact})) return outcome;
    if (!best) best = std::move(outcome);
  }
  return best;
}

}  // namespace remesher
