// SPDX-License-Identifier: MIT
// How a bag of triangles hangs together: which vertices are at one place, which triangles at one
// edge. Computed once, for the report and the mesh builder.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/triangle_mesh.h"
#include "mesh/edge_groups.h"

namespace remesher {

// Twins take much memory in a mesh of many millions of triangles, and only the builder needs them.
enum class Twins : char { Found, Unknown };

struct Welding {
  // mesh must be valid (see requireValid).
  explicit Welding(const TriangleMesh& mesh, Twins wanted = Twins::Found);

  // Visits each edge: all its halfedges, ascending, numbered as in `corners` (see EdgeGroups).
  template <class Visit>
  void forEachEdge(Visit visit) const {
    if (twins.empty()) forEachEdgeOf(first.size(), corners, visit);
    for (Index h = 0; h < twins.size(); ++h) {
      const std::array<Index, 2> edge = {h, twins[h]};
      if (h < twins[h]) visit(std::span(edge).first(twins[h] == kNone ? 1 : 2));
    }
  }

  // The triangles of the mesh that `corners` has, in its order.
  std::vector<Index> triangles(const TriangleMesh& mesh) const;

  std::vector<Index> first;    // per vertex: the first at its place
  std::vector<Index> corners;  // as in `first`; only of triangles with three different ones
  std::vector<Index> twins;    // of these corners; empty if twins do not suffice (see plainTwins)

 private:
  std::array<Index, 3> placesOf(const TriangleMesh& mesh, std::size_t t) const;
};

}  // namespace remesher
