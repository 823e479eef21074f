// SPDX-License-Identifier: MIT
#include "remesh/quads/shape/tip_distances.h"

#include <cmath>

#include "remesh/quads/mesh/triangulated.h"

namespace remesher {

std::vector<Tip> possibleTips(const OriginalSurface& surface) {
  const HalfedgeMesh& original = surface.mesh();
  std::vector<Tip> tips;
  std::vector<char> isOnCurve(original.vertexCapacity(), 0);
  const auto& chains = surface.curves().chains();
  for (Index i = 0; i < chains.size(); ++i)
    for (std::size_t k = 0; k < chains[i].vertices.size(); ++k) {
      const Vertex v = chains[i].vertices[k];
      isOnCurve[v.index] = 1;
      if (k > 0 && k + 1 < chains[i].vertices.size())
        tips.push_back({v.index, {i, chains[i].arcs[k]}});
    }
  for (Index v = 0; v < original.vertexCapacity(); ++v)
    if (original.isAlive(Vertex(v)) && !isOnCurve[v]) tips.push_back({v, {}});
  return tips;
}

QuadTree::QuadTree(const QuadMesh& mesh) : indices_(trianglesOf(mesh)) {
  for (const Placement& place : mesh.vertices) positions_.push_back(place.position);
  tree_.emplace(positions_, indices_);
}

std::array<Index, 3> QuadTree::corners(Index triangle) const {
  const std::size_t first = std::size_t{3} * triangle;
  return {indices_[first], indices_[first + 1], indices_[first + 2]};
}

// Most are still near the triangle that they were near before, or that the vertex before them is
// near.
void measure(std::vector<Tip>& possible, const QuadTree& tree, const OriginalSurface& surface,
             double least) {
  Index before = 0;
  for (Tip& tip : possible) {
    const Vec3& p = surface.positions()[Vertex(tip.vertex)];
    const auto found =
        (*tree).nearestBeyond(least, p, tip.triangle == kNone ? before : tip.triangle);
    tip.triangle = before = found.triangle;
    tip.distance = std::sqrt(found.squaredDistance);
  }
}

}  // namespace remesher
