// SPDX-License-Identifier: MIT
#include "steps/polish.h"

#include <doctest/doctest.h>

#include "support/runs.h"
#include "support/soups.h"

using namespace remesher;

namespace {

// Two shells, so flat that hardly any angle can be better.
TriangleMesh flatShells() {
  constexpr double kHeight = 0.01;
  TriangleMesh outer = shapes::icosphere(2), inner = outer;
  for (Vec3& p : inner.positions) p *= 0.9;
  TriangleMesh both = soups::joined({outer, inner});
  for (Vec3& p : both.positions) p.z() *= kHeight;
  return both;
}

}  // namespace

TEST_CASE("polish: what it takes to prove a bound on the error is in proportion to the mesh") {
  constexpr std::size_t kMost = 1300, kOneProof = 2000;  // pieces: to each triangle; at the end
  shapes::TestRun test(flatShells());
  const ErrorBound bound(test.surface, 0.002 * test.surface.diagonal());
  test.run.rule = fidelityRule({});
  test.run.rule.bound = &bound;
  polish(test.run, {radians(45)});
  CHECK(bound.piecesLookedAt() > kMost * test.mesh.mesh().faceCount() / 2);
  CHECK(bound.piecesLookedAt() < kMost * test.mesh.mesh().faceCount() + kOneProof);
  CHECK(shapes::checkWorkingMesh(test.mesh) == "");
}
