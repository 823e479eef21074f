// SPDX-License-Identifier: MIT
#include "remesh/schemes/guided.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/legible.h"
#include "base/place.h"
#include "geometry/extent.h"
#include "geometry/triangle_tree.h"
#include "remesh/guides/imprint.h"
#include "remesh/guides/kept_guides.h"
#include "remesh/guides/surface_guides.h"
#include "remesh/schemes/curve_choice.h"
#include "remesh/transfer/input_attributes.h"

namespace remesher {

namespace {

// In sides of quads: the steps along a guide; how near to a vertex a guide goes through it; how
// near to a guide the ends of sides that follow it are.
constexpr double kGuideStep = 1.0 / 6, kThrough = 0.05, kFollowed = 0.1;
// Less than this share of a guide's length is missing: less than any side.
constexpr double kWholly = 0.999;

// The divided mesh with the input's attributes at the same places.
TriangleMesh withAttributes(const Imprint& imprint, const TriangleMesh& input,
                            const PartOptions& options, double side) {
  TriangleMesh mesh = imprint.mesh();
  if (input.attributes.empty()) return mesh;
  mesh.attributes = input.attributes;
  BuiltMesh built = buildMesh(input);
  std::vector<std::string> chartless = curveCandidates(built, input, options, side).seams.chartless;
  const InputAttributes whole(input, std::move(built), std::move(chartless));
  for (auto v = Index(input.positions.size()); v < mesh.positions.size(); ++v)
    whole.append(imprint.placeOf(v), mesh.attributes);
  return mesh;
}

// The loops that are not sides of the quads all along.
void noteLost(RemeshOutcome& made, const std::vector<Guide>& loops, double near) {
  std::string lost;
  std::size_t count = 0;
  for (const Guide& guide : loops) {
    const double share = keptShare(guide, made.mesh, near);
    if (share >= kWholly) continue;
    lost += (count++ > 0 ? ", " : "") + legible(guide.name) + " (" +
            std::to_string(int(100 * share)) + " %)";
  }
  if (count > 0)
    made.warnings.push_back(
        {"GUIDES_NOT_KEPT",
         "Guides became sides of quads along a part of their length only: " + lost +
             "; they are too near to other curves, or too short for quads of this size.",
         count});
}

}  // namespace

double sideLength(const TriangleMesh& input, const PartOptions& options) {
  if (options.edgeLength) return *options.edgeLength;
  const double given = double(countPlaces(input.positions));
  const double vertices =
      options.vertices ? double(*options.vertices) : options.ratio.value_or(1) * given;
  return std::sqrt(extentOf(input).area / std::max(1.0, vertices));
}

std::vector<Guide> guidesOn(const TriangleMesh& input, const PartOptions& options) {
  if (options.guides.empty()) return {};
  const TriangleTree tree(input.positions, input.indices);
  return onSurface(options.guides, tree, kGuideStep * sideLength(input, options));
}

std::vector<std::vector<Guide>> guidesByPart(const TriangleMesh& input,
                                             const std::vector<SurfacePart>& parts,
                                             const std::vector<Guide>& guides) {
  std::vector<std::vector<Guide>> own(parts.size());
  if (guides.empty()) return own;
  const TriangleTree tree(input.positions, input.indices);
  std::vector<std::size_t> partOf(input.triangleCount(), parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (const Index t : parts[i].triangles) partOf[t] = i;
  for (const Guide& guide : guides) {
    std::vector<std::size_t> points(parts.size() + 1, 0);
    for (const Vec3& p : guide.points) ++points[partOf[tree.nearest(p).triangle]];
    const auto most = std::max_element(points.begin(), points.end() - 1) - points.begin();
    own[std::size_t(most)].push_back(guide);
  }
  return own;
}

RemeshOutcome remeshGuided(const TriangleMesh& input, const PartOptions& options,
                           const SurfaceRemesher& remesh) {
  const double side = sideLength(input, options);
  PartOptions own = options;
  own.guides.clear();
  const TriangleTree tree(input.positions, input.indices);
  std::vector<Guide> kept;
  Imprint imprint(input, options.featureEdges, kThrough * side);
  for (const Guide& guide : onSurface(options.guides, tree, kGuideStep * side)) {
    if (guide.kind == GuideKind::Direction) {
      own.guides.push_back(guide);
      continue;
    }
    kept.push_back(imprint.add(guide));
    if (kept.back().points.empty()) kept.back() = guide;
  }
  if (kept.empty()) return remesh(input, own);
  own.featureEdges = imprint.edges();
  RemeshOutcome made = remesh(withAttributes(imprint, input, options, side), own);
  for (InputPlace& place : made.places) place = imprint.onInput(place);
  noteLost(made, kept, kFollowed * side);
  return made;
}

}  // namespace remesher
