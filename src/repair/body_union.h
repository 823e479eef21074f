// SPDX-License-Identifier: MIT
// Closed bodies as one outside. Where that is not sound for all of them, those that no other
// touches are united for themselves, so that one bad body does not spoil the rest.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "base/triangle_mesh.h"
#include "mesh/submesh.h"
#include "repair/ladder.h"

namespace remesher {

struct BodyUnion {
  TriangleMesh mesh;
  std::vector<Index> parents;    // per triangle of the mesh that of the bodies in whose plane it is
  std::vector<Index> crossings;  // triangles of the mesh that intersect others
  double lost = 0;               // ratio of the area: what is seen of the bodies and is not there
  std::vector<Index> undecided;  // triangles of the bodies that have no sound union, ascending
};

// bodies: closed, facing outwards. crossings: their triangles that intersect others, ascending.
// mostLeft: the share of them that may be left. None if no body at all has a sound union.
std::optional<BodyUnion> unionOf(const TriangleMesh& bodies, std::span<const Index> crossings,
                                 double mostLeft = ladder::kMostCrossingsLeft);

// Some triangles of a mesh, with their numbers there.
struct SelectedTriangles {
  TriangleMesh mesh;  // with all vertices
  std::vector<Index> triangles;
};

// The triangles that have this mark.
SelectedTriangles selected(const TriangleMesh& mesh, std::span<const Index> marks, Index mark);

}  // namespace remesher
