// SPDX-License-Identifier: MIT
#include "mesh/welding.h"

#include "base/place.h"

namespace remesher {

namespace {

bool areDistinct(Index a, Index b, Index c) { return a != b && b != c && c != a; }

}  // namespace

Welding::Welding(const TriangleMesh& mesh, Twins wanted) : first(weld(mesh.positions)) {
  corners.reserve(mesh.indices.size());
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
    const auto [a, b, c] = placesOf(mesh, t);
    if (areDistinct(a, b, c)) corners.insert(corners.end(), {a, b, c});
  }
  if (wanted == Twins::Found) twins = plainTwins(first.size(), corners);
}

std::vector<Index> Welding::triangles(const TriangleMesh& mesh) const {
  std::vector<Index> given;
  given.reserve(corners.size() / 3);
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
    const auto [a, b, c] = placesOf(mesh, t);
    if (areDistinct(a, b, c)) given.push_back(Index(t));
  }
  return given;
}

std::array<Index, 3> Welding::placesOf(const TriangleMesh& mesh, std::size_t t) const {
  return {first[mesh.indices[3 * t]], first[mesh.indices[3 * t + 1]],
          first[mesh.indices[3 * t + 2]]};
}

}  // namespace remesher
