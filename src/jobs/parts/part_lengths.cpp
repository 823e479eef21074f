// SPDX-License-Identifier: MIT
#include "jobs/parts/part_lengths.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "jobs/parts/part_places.h"
#include "mesh/joining.h"

namespace remesher {
namespace {

void toPercent(const std::optional<double>& length, std::optional<double>& percent,
               double diagonal) {
  if (length) percent = 100 * *length / diagonal;
}

}  // namespace

double worldDiagonal(const std::vector<io::Part>& parts) {
  Eigen::AlignedBox3d box;
  for (const io::Part& part : parts) {
    if (!part.finer.empty()) continue;
    const bool isPlaced = !part.instances.empty();
    const Transform place = largestPlace(part);
    std::vector<char> isSeen(part.mesh.positions.size(), 0);
    for (const Index v : part.mesh.indices) {
      if (v >= isSeen.size() || std::exchange(isSeen[v], 1)) continue;
      const Vec3& p = part.mesh.positions[v];
      box.extend(isPlaced ? Vec3(place * p) : p);
    }
  }
  return box.isEmpty() ? 0 : box.diagonal().stableNorm();
}

double growthOf(const Transform& toWorld) {
  return std::cbrt(std::abs(toWorld.linear().determinant()));
}

PartOptions withPercents(PartOptions options, double diagonal) {
  if (!(diagonal > 0)) return options;
  const Lengths& lengths = options.lengths;
  toPercent(lengths.maxError, options.maxError, diagonal);
  toPercent(lengths.weld, options.weld, diagonal);
  toPercent(lengths.holesUpTo, options.holesUpTo, diagonal);
  toPercent(lengths.gap, options.gap, diagonal);
  toPercent(lengths.dropBelow, options.dropBelow, diagonal);
  return options;
}

void limitEdges(PartOptions& options) {
  constexpr double kShortest = 0.4, kLongest = 2;
  if (!options.edgeLength || !options.minAngle || options.maxError) return;
  const double mean = *options.edgeLength;
  const double least = options.minEdge.value_or(mean), most = options.maxEdge.value_or(mean);
  if (!options.minEdge) options.minEdge = kShortest * std::min(mean, most);
  if (!options.maxEdge) options.maxEdge = kLongest * std::max(mean, least);
}

PartOptions withPercents(const RemeshOptions& asked, const std::vector<io::Part>& parts) {
  const Lengths& l = asked.lengths;
  if (!l.maxError && !l.weld && !l.holesUpTo && !l.gap && !l.dropBelow) return PartOptions(asked);
  return withPercents(PartOptions(asked), worldDiagonal(parts));
}

PartOptions withPercentsOf(const TriangleMesh& mesh, double growth, PartOptions options) {
  const std::optional<double> dropBelow = options.dropBelow;
  options = withPercents(std::move(options), growth * diagonalOf(mesh));
  options.dropBelow = dropBelow;  // of all parts together
  return options;
}

}  // namespace remesher
