// SPDX-License-Identifier: MIT
#include "parts/part_targets.h"

#include <algorithm>
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
  for (const Transform& place : part.instances)
    sum += std::cbrt(std::abs(place.linear().determinant()));
  return sum / double(part.instances.size());
}

// The mean over its places: however often a part is shown, its triangles shall be as large as those
// of the others.
double worldArea(const io::Part& part) {
  double sum = 0;
  for (const Transform& place : part.instances)
    sum += std::pow(std::abs(place.linear().determinant()), 2.0 / 3);
  const double perArea = part.instances.empty() ? 1 : sum / double(part.instances.size());
  double area = 0;
  for (std::size_t i = 0; i + 2 < part.mesh.indices.size(); i += 3) {
    const Vec3& a = part.mesh.positions[part.mesh.indices[i]];
    const Vec3& b = part.mesh.positions[part.mesh.indices[i + 1]];
    const Vec3& c = part.mesh.positions[part.mesh.indices[i + 2]];
    area += 0.5 * (b - a).cross(c - a).norm();
  }
  return area * perArea;
}

}  // namespace

PartTargets::PartTargets(const std::vector<io::Part>& parts, const RemeshOptions& options)
    : parts_(parts), options_(options), order_(parts.size()) {
  if (parts.size() > 1 && !(options.density.empty() && options.featureEdges.empty()))
    throw Error(ErrorCode::InvalidOption,
                "density and featureEdges need a file with one mesh, not with " +
                    std::to_string(parts.size()) + ".",
                "Give the meshes one by one.");
  for (const io::Part& part : parts) areas_.push_back(worldArea(part));
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::stable_sort(order_.begin(), order_.end(),
                   [&](std::size_t a, std::size_t b) { return areas_[a] < areas_[b]; });
  areaLeft_ = std::accumulate(areas_.begin(), areas_.end(), 0.0);
  verticesLeft_ = options.vertices ? double(*options.vertices) : 0;
}

RemeshOptions PartTargets::of(std::size_t part) const {
  RemeshOptions result = options_;
  const bool isLast = part == order_.back();
  // The last part has only what is left; and a whole that asks for no number asks for no fewer.
  const bool asksForNone = !options_.vertices && !options_.ratio && !options_.edgeLength;
  const bool isOneOfMany = parts_.size() > 1 && !(isLast && options_.vertices);
  if (asksForNone || isOneOfMany) result.tooFew = TooFew::Raise;
  if (options_.vertices) {
    const double share = isLast || !(areaLeft_ > 0) ? 1 : areas_[part] / areaLeft_;
    result.vertices = Index(std::llround(share * verticesLeft_));
  }
  if (options_.edgeLength) *result.edgeLength /= scaleOf(parts_[part]);
  return result;
}

void PartTargets::given(std::size_t part, std::size_t vertices) {
  areaLeft_ -= areas_[part];
  verticesLeft_ = std::max(0.0, verticesLeft_ - double(vertices));
}

}  // namespace remesher
