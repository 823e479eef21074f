// SPDX-License-Identifier: MIT
#include "remesh/quads/shape/tip_distances.h"

#include <cmath>

#include "geometry/distance_sampler.h"

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

// Most are still near the triangle that they were near before, or that the vertex before them is
// near.
void measure(std::vector<Tip>& possible, const QuadTree& tree, const OriginalSurface& surface,
             double least) {
  DistanceSampler sampler(*tree);
  sampler.beginAt(0);
  for (Tip& tip : possible) {
    if (tip.triangle != kNone) sampler.beginAt(tip.triangle);
    tip.distance = std::sqrt(sampler.addBeyond(least, surface.positions()[Vertex(tip.vertex)]));
    tip.triangle = sampler.near();
  }
}

}  // namespace remesher
