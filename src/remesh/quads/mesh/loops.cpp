// SPDX-License-Identifier: MIT
#include "remesh/quads/mesh/loops.h"

#include <algorithm>
#include <vector>

#include "base/disjoint_sets.h"
#include "remesh/quads/mesh/quad_sides.h"

namespace remesher {

double longestLoop(const QuadMesh& mesh) {
  const QuadSides sides(mesh.vertices.size(), mesh.quads);
  DisjointSets loops(sides.size());
  for (Index side = 0; side < sides.size(); ++side) {
    loops.unite(side, nextSide(nextSide(side)));
    if (sides.across(side) != kNone) loops.unite(side, sides.across(side));
  }
  std::vector<std::size_t> crossed(sides.size(), 0);
  std::size_t longest = 0, edges = 0;
  for (Index side = 0; side < sides.size(); ++side) {
    if (sides.across(side) != kNone && sides.across(side) < side) continue;
    ++edges;
    longest = std::max(longest, ++crossed[loops.find(side)]);
  }
  return edges > 0 ? double(longest) / double(edges) : 0;
}

}  // namespace remesher
