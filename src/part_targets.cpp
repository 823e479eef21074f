// SPDX-License-Identifier: MIT
#include "part_targets.h"

#include <cmath>
#include <numeric>
#include <string>

#include "base/error.h"

namespace remesher {
namespace {

// How much longer lengths are in the world than in the part: the mean over its instances.
double scaleOf(const io::Part& part) {
  if (part.instances.empty()) return 1;
  double sum = 0;
  for (const io::Transform& place : part.instances)
    sum += std::cbrt(std::abs(place.linear().determinant()));
  return sum / double(part.instances.size());
}

double worldArea(const io::Part& part) {
  double area = 0;
  for (std::size_t i = 0; i + 2 < part.mesh.indices.size(); i += 3) {
    const Vec3& a = part.mesh.positions[part.mesh.indices[i]];
    const Vec3& b = part.mesh.positions[part.mesh.indices[i + 1]];
    const Vec3& c = part.mesh.positions[part.mesh.indices[i + 2]];
    area += 0.5 * (b - a).cross(c - a).norm();
  }
  return area * scaleOf(part) * scaleOf(part);
}

// Whole numbers in proportion to `weights` that add up to `total`: each running sum is rounded.
std::vector<Index> sharedOut(Index total, const std::vector<double>& weights) {
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  // Nothing can be shared out by what is not there; the parts will be refused each.
  if (!(sum > 0)) return std::vector<Index>(weights.size(), total);
  std::vector<Index> shares;
  double reached = 0;
  Index given = 0;
  for (double weight : weights) {
    reached += weight;
    const auto upToHere = static_cast<Index>(std::llround(reached / sum * total));
    shares.push_back(upToHere - given);
    given = upToHere;
  }
  return shares;
}

}  // namespace

std::vector<RemeshOptions> optionsPerPart(const std::vector<io::Part>& parts,
                                          const RemeshOptions& options) {
  std::vector<RemeshOptions> result(parts.size(), options);
  if (parts.size() > 1 && !(options.density.empty() && options.featureEdges.empty()))
    throw Error(ErrorCode::InvalidOption,
                "density and featureEdges need a file with one mesh, not with " +
                    std::to_string(parts.size()) + ".",
                "Give the meshes one by one.");
  if (options.vertices) {
    std::vector<double> areas;
    for (const io::Part& part : parts) areas.push_back(worldArea(part));
    const std::vector<Index> shares = sharedOut(*options.vertices, areas);
    for (std::size_t i = 0; i < parts.size(); ++i) result[i].vertices = shares[i];
  }
  if (options.edgeLength)
    for (std::size_t i = 0; i < parts.size(); ++i)
      result[i].edgeLength = *options.edgeLength / scaleOf(parts[i]);
  return result;
}

}  // namespace remesher
