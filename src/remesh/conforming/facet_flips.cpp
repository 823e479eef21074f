// SPDX-License-Identifier: MIT
#include "remesh/conforming/facet_flips.h"

#include "geometry/opposite_angles.h"

namespace remesher {

std::vector<Halfedge> edgesOf(const HalfedgeMesh& mesh) {
  std::vector<Halfedge> edges;
  for (Index i = 0; i < mesh.halfedgeCapacity(); ++i)
    if (mesh.isEdge(Halfedge(i))) edges.emplace_back(i);
  return edges;
}

bool wantsFacetFlip(const FacetedMesh& mesh, Halfedge h, DeepEdges deep) {
  // A flip must be clearly better, so that rounding turns no edge to and fro.
  constexpr double kClearly = 1e-9;
  if (mesh.isLine(h)) return false;
  const HalfedgeMesh& m = mesh.mesh();
  const Index facet = mesh.facet(m.face(h));
  const auto at = [&](Vertex v) { return mesh.flat(v, facet); };
  const Vertex a = m.origin(h), b = m.tip(h), c = m.opposite(h), d = m.opposite(m.twin(h));
  if (deep == DeepEdges::Flipped && mesh.isBent(facet)) {
    const bool isDeep = mesh.isDeep(a, b, facet), wouldBe = mesh.isDeep(c, d, facet);
    if (isDeep != wouldBe) return isDeep;
  }
  return sineOfOpposite(at(a), at(b), at(c), at(d)) < -kClearly;
}

}  // namespace remesher
