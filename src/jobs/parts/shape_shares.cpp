// SPDX-License-Identifier: MIT
#include "jobs/parts/shape_shares.h"

#include <algorithm>
#include <cmath>

#include "base/place.h"
#include "mesh/mesh_builder.h"
#include "remesh/schemes/follow.h"

namespace remesher {

ShapeShares::ShapeShares(const std::vector<io::Part>& parts, const std::vector<PartPlace>& places,
                         Textures textures)
    : parts_(parts.size()) {
  constexpr double kPower = 5.0 / 3;  // costs are fifth powers of lengths, determinants third
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (places[i].area <= 0) continue;
    const TriangleMesh& mesh = parts[i].mesh;
    parts_[i] = {double(countPlaces(mesh.positions)), followCosts(buildMesh(mesh), mesh, textures)};
    const double volume = std::abs(places[i].toWorld.linear().determinant());
    for (double& cost : parts_[i].costs) cost *= std::pow(volume, kPower);
  }
}

std::vector<double> ShapeShares::shares(std::span<const std::size_t> waiting,
                                        double vertices) const {
  double own = 0;
  std::vector<double> all;
  for (const std::size_t i : waiting) {
    own += parts_[i].own;
    all.insert(all.end(), parts_[i].costs.begin(), parts_[i].costs.end());
  }
  const auto excess = std::size_t(std::max(0.0, std::ceil(own - vertices)));
  double dearest = kInfinity;
  if (excess < all.size()) {
    std::nth_element(all.begin(), all.begin() + std::ptrdiff_t(excess), all.end());
    dearest = all[excess];
  }
  std::vector<double> result;
  for (const std::size_t i : waiting) {
    const std::vector<double>& costs = parts_[i].costs;
    const auto gone = std::lower_bound(costs.begin(), costs.end(), dearest) - costs.begin();
    result.push_back(std::max(1.0, parts_[i].own - double(gone)));
  }
  return result;
}

}  // namespace remesher
