// SPDX-License-Identifier: MIT
// How a bag of triangles hangs together: which vertices are at one place, and which triangles at
// one edge. Worked out once for whoever asks: for the report as for the mesh builder.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/triangle_mesh.h"
#include "mesh/edge_groups.h"

namespace remesher {

struct Welding {
  // Of a mesh that is valid (see requireValid).
  explicit Welding(const TriangleMesh& mesh);

  // All halfedges of each edge, ascending: of these corners (see EdgeGroups).
  template <class Visit>
  void forEachEdge(Visit visit) const {
    if (twins.empty()) {
      const EdgeGroups edges(first.size(), corners);
      for (std::size_t e = 0; e < edges.size(); ++e) visit(edges[e]);
    }
    for (Index h = 0; h < twins.size(); ++h) {
      const std::array<Index, 2> edge = {h, twins[h]};
      if (h < twins[h]) visit(std::span(edge).first(twins[h] == kNone ? 1 : 2));
    }
  }

  std::vector<Index> first;    // per vertex: the first at its place
  std::vector<Index> corners;  // by these, of the triangles that have three: others have no edges
  std::vector<Index> twins;  // of these corners, where that says it all (see plainTwins), or empty
};

}  // namespace remesher
