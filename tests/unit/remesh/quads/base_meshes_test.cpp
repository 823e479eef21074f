// SPDX-License-Identifier: MIT
#include "remesh/quads/base_meshes.h"

#include <doctest/doctest.h>

#include "remesh/quads/mesh/quad_parts.h"
#include "support/working_meshes.h"

using namespace remesher;

TEST_CASE("base_meshes: there are two meshes, where the second is coarser; parts stay apart") {
  TriangleMesh both = shapes::icosphere(4);
  const TriangleMesh other = shapes::torus(12, 8);
  const Index first = Index(both.positions.size());
  for (const Vec3& p : other.positions) both.positions.push_back(p + Vec3(9, 0, 0));
  for (const Index v : other.indices) both.indices.push_back(first + v);
  const OriginalSurface surface = shapes::surfaceOf(both);
  std::vector<std::size_t> asked;
  const TriangleMaker triangles = [&](std::size_t vertices) {
    asked.push_back(vertices);
    return WorkingMesh(surface);
  };
  BaseMeshes bases(triangles, 5000, 1000);
  REQUIRE(bases.parts().size() == 2);
  const FaceData<Index> numbers = partNumbers(surface.mesh());
  for (const std::size_t level : {1, 0})
    for (const Index number : {0, 1}) {
      const WorkingMesh* part = bases.part(level, number);
      REQUIRE(part);
      CHECK(numbers[part->at(Vertex(0)).face] == number);
      const Vec3& p = part->position(Vertex(0));
      CHECK((p.x() > 5) == (number == numbers[bases.parts()[1].at(Vertex(0)).face]));
    }
  CHECK_FALSE(bases.part(2, 0));
  CHECK(asked == std::vector<std::size_t>{5000, 1000});
  CHECK_FALSE(BaseMeshes(triangles, 1000, 1000).part(1, 0));
}
