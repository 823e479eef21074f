// SPDX-License-Identifier: MIT
#include "jobs/checks/whole_steps.h"

#include "base/place.h"

namespace remesher {

namespace {

// Rounding the ends of an edge this many whole steps long turns it by less than a degree.
constexpr double kShortestEdgeInSteps = 64;

bool hasShortEdge(const TriangleMesh& mesh, const WholeSteps& steps) {
  const double shortest = kShortestEdgeInSteps / steps.perUnit;
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
    const Vec3 edge = mesh.positions[mesh.indices[next]] - mesh.positions[mesh.indices[i]];
    if (edge.norm() < shortest) return true;
  }
  return false;
}

}  // namespace

std::optional<std::vector<Vec3>> inWholeSteps(const TriangleMesh& mesh, const WholeSteps& steps) {
  std::vector<Vec3> rounded;
  for (const Vec3& p : mesh.positions) {
    const Vec3 whole = (p * steps.perUnit).array().round();
    if (whole.minCoeff() < steps.lowest || whole.maxCoeff() > steps.highest) return {};
    // Files are read in single precision.
    rounded.push_back((whole.cast<float>() / static_cast<float>(steps.perUnit)).cast<double>());
  }
  if (hasShortEdge(mesh, steps) || countPlaces(rounded) < countPlaces(mesh.positions)) return {};
  return rounded;
}

}  // namespace remesher
