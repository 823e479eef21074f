// SPDX-License-Identifier: MIT
// Whether quads are a surface, and of which kind: the laws that every result keeps.
#pragma once

#include <string>

#include "mesh/halfedge_mesh.h"
#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

// The numbers that tell one kind of surface from another.
struct SurfaceKind {
  long eulerCharacteristic = 0;
  std::size_t components = 0;
  std::size_t boundaryLoops = 0;
  bool operator==(const SurfaceKind&) const = default;
};

SurfaceKind kindOf(const HalfedgeMesh& mesh);
SurfaceKind kindOf(const QuadMesh& mesh);  // which must be a manifold

// The first broken law in words, empty if all hold: four different corners per quad, every vertex
// in use, a manifold, no doublet, and one curve for both sides of an edge. A doublet is an inner
// vertex with only two quads.
std::string check(const QuadMesh& mesh);

}  // namespace remesher
