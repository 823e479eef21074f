// SPDX-License-Identifier: MIT
#include "mesh/halfedge_mesh.h"

#include <doctest/doctest.h>

using namespace remesher;

TEST_CASE("halfedge_mesh: two triangles share one edge and keep four on the boundary") {
  const std::vector<Index> square = {0, 1, 2, 0, 2, 3};
  const HalfedgeMesh mesh(4, square);
  int boundary = 0;
  for (Index h = 0; h < mesh.halfedgeCapacity(); ++h) boundary += mesh.isBoundary(Halfedge(h));
  CHECK(boundary == 4);
  CHECK(mesh.triangles() == square);
}
