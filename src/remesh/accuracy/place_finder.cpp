// SPDX-License-Identifier: MIT
#include "remesh/accuracy/place_finder.h"

#include <utility>

namespace remesher {

namespace {

// Vertices.
constexpr std::size_t kEnoughSeen = 4;

}  // namespace

PlaceFinder::PlaceFinder(const WorkingMesh& mesh)
    : mesh_(mesh),
      begins_(mesh.surface().mesh().faceCapacity() + 1, 0),
      isSeen_(mesh.surface().mesh().faceCapacity(), 0) {
  const HalfedgeMesh& m = mesh.mesh();
  const auto forEachVertex = [&](const auto& visit) {
    for (Index i = 0; i < m.vertexCapacity(); ++i)
      if (m.isAlive(Vertex(i))) visit(Vertex(i), mesh.at(Vertex(i)).face.index);
  };
  forEachVertex([&](Vertex, Index face) { ++begins_[face]; });
  Index sum = 0;
  for (Index& begin : begins_) begin = sum += begin;
  vertices_.resize(sum);
  // Each face's list is filled from its end, which so becomes its beginning.
  forEachVertex([&](Vertex v, Index face) { vertices_[--begins_[face]] = v; });
}

std::vector<Vertex> PlaceFinder::verticesNear(const SurfacePoint& place) {
  const HalfedgeMesh& original = mesh_.surface().mesh();
  std::vector<Vertex> found;
  std::vector<Face> seen = {place.face};
  isSeen_[place.face] = 1;
  for (std::size_t i = 0; i < seen.size() && found.size() < kEnoughSeen; ++i) {
    const Face f = seen[i];
    for (Index k = begins_[f.index]; k < begins_[f.index + 1]; ++k) found.push_back(vertices_[k]);
    for (int side = 0; side < 3; ++side) {
      const Halfedge across = original.twin(HalfedgeMesh::halfedge(f, side));
      if (!across) continue;
      const Face next = HalfedgeMesh::face(across);
      if (!std::exchange(isSeen_[next], 1)) seen.push_back(next);
    }
  }
  for (const Face f : seen) isSeen_[f] = 0;
  return found;
}

}  // namespace remesher
