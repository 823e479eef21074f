// SPDX-License-Identifier: MIT
#include "repair/one_sided.h"

#include "base/disjoint_sets.h"
#include "base/place.h"
#include "mesh/edge_groups.h"
#include "mesh/orientation.h"

namespace remesher {

OneSided oneSidedOf(const TriangleMesh& mesh) {
  const std::vector<Index> first = weld(mesh.positions);
  std::vector<Index> corners, triangles;
  for (Index t = 0; t < mesh.triangleCount(); ++t) {
    const auto at = [&](std::size_t k) { return first[mesh.indices[3 * std::size_t{t} + k]]; };
    if (at(0) == at(1) || at(1) == at(2) || at(2) == at(0)) continue;
    corners.insert(corners.end(), {at(0), at(1), at(2)});
    triangles.push_back(t);
  }
  const EdgeGroups edges(first.size(), corners);
  const Orientation orientation = orient(corners, edges);
  OneSided result;
  if (orientation.conflicts == 0) return result;
  DisjointSets parts(triangles.size());
  std::vector<Index> seams;  // a triangle at each
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const Index h = edges[e][0], g = edges[e].back();
    for (const Index other : edges[e]) parts.unite(h / 3, other / 3);
    if (edges[e].size() != 2) continue;
    const bool agree = corners[h] != corners[g];
    if (agree == (orientation.turn[h / 3] == orientation.turn[g / 3])) continue;
    const Vec3 &a = mesh.positions[corners[h]], &b = mesh.positions[corners[nextCorner(h)]];
    if (seams.empty()) result.at = (a + b) / 2;
    seams.push_back(h / 3);
  }
  result.edges = seams.size();
  std::vector<char> isOneSided(triangles.size(), 0);
  for (const Index t : seams) isOneSided[parts.find(t)] = 1;
  for (Index t = 0; t < triangles.size(); ++t)
    if (isOneSided[parts.find(t)]) result.triangles.push_back(triangles[t]);
  return result;
}

}  // namespace remesher
