// SPDX-License-Identifier: MIT
// Pieces of a surface that hang together.
#pragma once

#include <vector>

#include "base/disjoint_sets.h"
#include "mesh/halfedge_mesh.h"

namespace remesher {

struct FaceRegions {
  FaceData<Index> of;  // per face, from 0 on in the order of first faces; kNone for dead ones
  Index count = 0;
};

// The regions of faces that are joined across edges for which isOpen(halfedge) holds.
template <class Open>
FaceRegions regionsOf(const HalfedgeMesh& mesh, Open isOpen) {
  FaceRegions regions{FaceData<Index>(mesh.faceCapacity(), kNone)};
  std::vector<Face> stack;
  const auto visit = [&](Face f) {
    regions.of[f] = regions.count;
    stack.push_back(f);
  };
  for (Index i = 0; i < mesh.faceCapacity(); ++i) {
    if (!mesh.isAlive(Face(i)) || regions.of[Face(i)] != kNone) continue;
    visit(Face(i));
    while (!stack.empty()) {
      const Face f = stack.back();
      stack.pop_back();
      for (int k = 0; k < 3; ++k) {
        const Halfedge h = HalfedgeMesh::halfedge(f, k), twin = mesh.twin(h);
        if (twin && isOpen(h) && regions.of[HalfedgeMesh::face(twin)] == kNone)
          visit(HalfedgeMesh::face(twin));
      }
    }
    ++regions.count;
  }
  return regions;
}

inline FaceRegions componentsOfFaces(const HalfedgeMesh& mesh) {
  return regionsOf(mesh, [](Halfedge) { return true; });
}

// The vertices of each component as one set.
inline DisjointSets componentsOfVertices(const HalfedgeMesh& mesh) {
  DisjointSets components(mesh.vertexCapacity());
  for (Index i = 0; i < mesh.faceCapacity(); ++i) {
    if (!mesh.isAlive(Face(i))) continue;
    const auto [a, b, c] = mesh.vertices(Face(i));
    components.unite(a.index, b.index);
    components.unite(b.index, c.index);
  }
  return components;
}

}  // namespace remesher
