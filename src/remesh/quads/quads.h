// SPDX-License-Identifier: MIT
// From even triangles to quads alone. Two ways: a seamless map of the triangles to the plane, whose
// unit squares are the quads; and, for each connected part where the map does not give a surface of
// the same kind, pairs of triangles divided, which always do.
#pragma once

#include <functional>

#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

struct MadeQuads {
  QuadMesh mesh;
  std::size_t parts = 0;      // connected ones
  std::size_t paired = 0;     // of them, those made of pairs of triangles
  std::size_t collapsed = 0;  // quads taken out to reach the number
};

// Even, compact triangles of about so many vertices on the surface, all of them on one and the
// same.
using TriangleMaker = std::function<WorkingMesh(std::size_t vertices)>;

struct QuadGoal {
  std::size_t vertices = 0;
  bool isExact = false;  // else within a hundredth
};

// By way of triangles that `triangles` makes.
MadeQuads makeQuads(const QuadGoal& goal, const TriangleMaker& triangles);

// By the map, for one connected part; no quads where it fails.
QuadMesh mapToQuads(const WorkingMesh& part, double vertices);

// By pairs: about four times as many vertices as the mesh has. length: of the quads' sides.
QuadMesh pairToQuads(const WorkingMesh& mesh, double length);

}  // namespace remesher
