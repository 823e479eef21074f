// SPDX-License-Identifier: MIT
#include "remesh/schemes/bodies.h"

#include <algorithm>
#include <utility>

#include "base/place.h"
#include "remesh/schemes/follow.h"

namespace remesher {

Index Bodies::bodyOf(const WorkingMesh& mesh, Face face) const {
  const SurfacePoint point = mesh.cornerPoint(HalfedgeMesh::halfedge(face));
  return ofGroup_[input_.groups[mesh.surface().built().triangles[point.face]]];
}

std::size_t Bodies::countPlaces(const WorkingMesh& mesh) const {
  const HalfedgeMesh& m = mesh.mesh();
  if (ofGroup_.empty()) return distinctPositions(m, mesh.positions());
  std::vector<std::pair<Index, Index>> visits;  // pairs of body and vertex
  for (Index f = 0; f < m.faceCapacity(); ++f) {
    if (!m.isAlive(Face(f))) continue;
    const Index body = bodyOf(mesh, Face(f));
    for (const Vertex v : m.vertices(Face(f))) visits.emplace_back(body, v.index);
  }
  std::sort(visits.begin(), visits.end());
  visits.erase(std::unique(visits.begin(), visits.end()), visits.end());
  std::size_t count = 0;
  std::vector<Vec3> places;
  for (std::size_t i = 0; i < visits.size(); ++i) {
    places.push_back(mesh.position(Vertex(visits[i].second)));
    if (i + 1 < visits.size() && visits[i + 1].first == visits[i].first) continue;
    count += remesher::countPlaces(places);
    places.clear();
  }
  return count;
}

}  // namespace remesher
