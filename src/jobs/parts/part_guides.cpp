// SPDX-License-Identifier: MIT
#include "jobs/parts/part_guides.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/legible.h"
#include "geometry/triangle_tree.h"
#include "jobs/parts/part_lengths.h"

namespace remesher {

namespace {

// A guide farther away than this share of the diagonal was hardly meant for the surface.
constexpr double kFarAway = 0.01;
// A place of so many of a surface's is tried; thousands are those of leaves or screws.
constexpr std::size_t kMostPlaces = 64;

// How far points are from a surface, on average and at most.
struct Distances {
  double mean = kInfinity, farthest = kInfinity;
};

Distances distancesOf(const Guide& guide, const TriangleTree& tree) {
  Distances all{0, 0};
  for (const Vec3& p : guide.points) {
    const double away = std::sqrt(tree.nearest(p).squaredDistance);
    all.mean += away / double(guide.points.size());
    all.farthest = std::max(all.farthest, away);
  }
  return all;
}

struct NearestSurface {
  std::size_t surface = 0;
  Transform place = Transform::Identity();
  Distances distances;
};

void lookAt(const io::Part& part, std::size_t number, const std::vector<Guide>& guides,
            std::vector<NearestSurface>& nearest) {
  std::vector<Transform> places = part.instances;
  if (places.empty()) places.push_back(Transform::Identity());
  if (places.size() > kMostPlaces) places.resize(kMostPlaces);
  for (const Transform& place : places) {
    if (!(std::abs(place.linear().determinant()) > 0)) continue;
    std::vector<Vec3> positions = part.mesh.positions;
    for (Vec3& p : positions) p = place * p;
    const TriangleTree tree(positions, part.mesh.indices);
    for (std::size_t g = 0; g < guides.size(); ++g) {
      const Distances distances = distancesOf(guides[g], tree);
      if (distances.mean < nearest[g].distances.mean) nearest[g] = {number, place, distances};
    }
  }
}

std::string inPercent(double share) { return std::to_string(std::llround(100 * share)); }

}  // namespace

SharedGuides sharedGuides(const std::vector<io::Part>& surfaces, const PartOptions& options) {
  if (options.guides.empty()) return {};
  if (!options.quads)
    throw Error(ErrorCode::InvalidOption,
                "guides are lines that quads follow, and triangles were "
                "asked for.",
                "Ask for quads, or leave out guides.");
  std::vector<NearestSurface> nearest(options.guides.size());
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    if (!surfaces[i].mesh.indices.empty()) lookAt(surfaces[i], i, options.guides, nearest);
  const double diagonal = worldDiagonal(surfaces);
  SharedGuides shared;
  shared.ofSurface.resize(surfaces.size());
  std::string far;
  std::size_t count = 0;
  for (std::size_t g = 0; g < nearest.size(); ++g) {
    const auto& [surface, place, distances] = nearest[g];
    if (surfaces.empty() || distances.mean == kInfinity) continue;
    Guide own = options.guides[g];
    const Transform back = place.inverse();
    for (Vec3& p : own.points) p = back * p;
    shared.ofSurface[surface].push_back(std::move(own));
    const double share = distances.farthest / diagonal;
    if (!(share > kFarAway)) continue;
    far += (count++ > 0 ? ", " : "") + legible(options.guides[g].name) + " (by " +
           inPercent(share) + " %)";
  }
  if (count > 0)
    shared.warnings.push_back({"GUIDES_FAR_AWAY",
                               "Guides are farther from the surface than 1 % of the diagonal: " +
                                   far + "; the quads follow the nearest places on it.",
                               count});
  return shared;
}

}  // namespace remesher
