// SPDX-License-Identifier: MIT
#include "remesh/guides/kept_guides.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "geometry/triangle.h"
#include "remesh/guides/surface_guides.h"

namespace remesher {

namespace {

// A side follows a stretch of the guide that is at most so many times as long: of a longer one it
// is a shortcut.
constexpr double kLongest = 1.5;

using Stretches = std::vector<std::pair<double, double>>;

double unitedLength(Stretches stretches) {
  std::sort(stretches.begin(), stretches.end());
  double sum = 0, end = -kInfinity;
  for (const auto& [from, to] : stretches) {
    sum += std::max(0.0, to - std::max(from, end));
    end = std::max(end, to);
  }
  return sum;
}

}  // namespace

double keptShare(const Guide& guide, const TriangleMesh& quads, double near) {
  const double whole = lengthOf(guide);
  if (!(whole > 0)) return 1;
  std::vector<NearestOnGuide> places;
  for (const Vec3& p : quads.positions) places.push_back(nearestOn(guide, p));
  Stretches stretches;
  const std::vector<Index> corners = quadsOf(quads);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Index a = corners[i], b = corners[i / 4 * 4 + (i + 1) % 4];
    if (places[a].distance > near || places[b].distance > near) continue;
    const auto [from, to] = std::minmax(places[a].along, places[b].along);
    const double most = kLongest * distance(quads.positions[a], quads.positions[b]);
    if (to - from <= most) stretches.emplace_back(from, to);
    if (!guide.isClosed || from + whole - to > most) continue;
    stretches.emplace_back(0, from);
    stretches.emplace_back(to, whole);
  }
  return std::min(1.0, unitedLength(std::move(stretches)) / whole);
}

}  // namespace remesher
