// SPDX-License-Identifier: MIT
#include "remesh/schemes/rounds.h"

#include <doctest/doctest.h>

#include "support/working_meshes.h"

using namespace remesher;

TEST_CASE("rounds: needles are not split without end where sizes are graded") {
  constexpr std::size_t kWanted = 64;
  TriangleMesh ring = shapes::torus(16, 6);
  for (Vec3& p : ring.positions) p.x() *= 1000;
  const OriginalSurface surface = shapes::surfaceOf(ring);
  SizeField sizes(surface, {.vertices = double(kWanted), .adaptivity = 0.5});
  REQUIRE_FALSE(sizes.isEven());
  Projector projector(surface, Projection::Patches, 2 * sizes.mean());
  WorkingMesh mesh(surface);
  Run run{mesh, projector, sizes, {}};
  run.asked.rule.mode = Fidelity::Loose;
  const std::size_t given = mesh.mesh().vertexCount();
  runRounds(run, {kWanted}, {});
  // Places of vertices that went are kept, so that these are as many as there ever were at a time.
  CHECK(mesh.mesh().vertexCapacity() <= 4 * given);
  CHECK(shapes::checkWorkingMesh(mesh) == "");
}
