// SPDX-License-Identifier: MIT
#include "remesh/steps/polish.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "mesh/hubs.h"
#include "support/hostile_shapes.h"
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

constexpr Index kTip = 0;

// Three triangles of 30° at a tip, on a body of better ones.
TriangleMesh spindle() {
  TriangleMesh mesh;
  shapes::addVertex(mesh, {0, 0, 3.19});
  for (int k = 0; k < 3; ++k) shapes::addVertex(mesh, shapes::onCircle(2 * k, 6));
  for (int k = 0; k < 3; ++k)
    shapes::addVertex(mesh, shapes::onCircle(2 * k + 1, 6) + Vec3(0, 0, -1.2));
  for (Index k = 0; k < 3; ++k) {
    const Index next = (k + 1) % 3;
    shapes::addTriangle(mesh, kTip, 1 + k, 1 + next);
    shapes::addTriangle(mesh, 1 + k, 4 + k, 1 + next);
    shapes::addTriangle(mesh, 1 + next, 4 + k, 4 + next);
  }
  shapes::addTriangle(mesh, 4, 6, 5);
  return mesh;
}

OriginalSurface tipped(const TriangleMesh& input) {
  BuiltMesh built = buildMesh(input);
  CurveRules rules;
  rules.corners = {Vertex(kTip)};
  FeatureCurves curves(built.mesh, built.positions, rules);
  return OriginalSurface(std::move(built), std::move(curves));
}

}  // namespace

TEST_CASE("polish: what it takes to prove a bound on the error is in proportion to the mesh") {
  constexpr std::size_t kOneProof = 2000;  // pieces of surface, at the end
  shapes::TestRun test(flatShells());
  const ErrorBound bound(test.surface, 0.002 * test.surface.diagonal());
  test.run.asked.rule = fidelityRule({});
  test.run.asked.rule.bound = &bound;
  grantProofs(test.run);
  polish(test.run, {radians(45)});
  CHECK(bound.piecesLookedAt() > kProofs * test.mesh.mesh().faceCount() / 2);
  CHECK(bound.piecesLookedAt() < kProofs * test.mesh.mesh().faceCount() + kOneProof);
  CHECK(shapes::checkWorkingMesh(test.mesh) == "");
}

TEST_CASE("polish: of an even sphere few triangles are poor, of flat shells many") {
  CHECK(areFewBelow(shapes::TestRun(shapes::icosphere(6)).run, radians(33)));
  CHECK_FALSE(areFewBelow(shapes::TestRun(flatShells()).run, radians(33)));
}

TEST_CASE("polish: around a tip that stays vertices leave the surface a little, for wider angles") {
  const TriangleMesh input = spindle();
  const OriginalSurface surface = tipped(input);
  SizeField sizes(surface, {.vertices = double(input.positions.size()), .adaptivity = 0});
  Projector projector(surface, Projection::Patches, 2 * sizes.mean());
  WorkingMesh mesh(surface);
  Run run{mesh, projector, sizes, {}};
  REQUIRE(shapes::worstAngle(mesh) < radians(30.1));
  polish(run, {radians(33), kSmallShift});
  CHECK(shapes::worstAngle(mesh) >= radians(33));
  CHECK(mesh.mesh().vertexCount() == input.positions.size());
  CHECK(mesh.position(Vertex(kTip)) == input.positions[kTip]);
}

TEST_CASE("polish: a hub stays, for no place gives its triangles angles") {
  constexpr Index kHub = 0;
  TriangleMesh input = shapes::wheel(Hubs::kFewestSpokes);
  input.positions[kHub].x() = 0.3;
  shapes::TestRun test(input);
  test.run.asked.rule = fidelityRule({});
  polish(test.run, {radians(20)});
  CHECK(test.mesh.position(Vertex(kHub)) == input.positions[kHub]);
  CHECK(shapes::checkWorkingMesh(test.mesh) == "");
}
