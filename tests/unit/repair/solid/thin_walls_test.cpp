// SPDX-License-Identifier: MIT
#include "repair/solid/thin_walls.h"

#include <doctest/doctest.h>

#include "measure/hausdorff.h"
#include "measure/mesh_report.h"
#include "measure/self_intersections.h"
#include "repair/solid/solid.h"
#include "support/shapes.h"
#include "support/soups.h"

using namespace remesher;

namespace {

constexpr double kSpacing = 0.05;
constexpr std::size_t kEnough = 4000000;

TriangleMesh plate(double thickness, double turn) {
  TriangleMesh mesh = soups::cube(0, 1);
  const Eigen::AngleAxisd turned(turn, Vec3(1, 2, 3).normalized());
  for (Vec3& p : mesh.positions) p = turned * Vec3(2 * p.x(), 1.5 * p.y(), thickness * p.z());
  return mesh;
}

Solid solidWithin(const TriangleMesh& mesh, std::size_t mostPoints) {
  SolidRule rule{kSpacing};
  rule.mostPoints = mostPoints;
  return solidOf(mesh, rule);
}

double farthest(const TriangleMesh& mesh, const Solid& solid) {
  return measureDeviation(mesh, solid.mesh, Maximum::Sampled).toOriginal.maximum;
}

double offset(const TriangleMesh& mesh, const Solid& solid) {
  return measureDeviation(mesh, solid.mesh, Maximum::Sampled).toOriginal.rms;
}

}  // namespace

TEST_CASE("thin walls: both sides of a plate thinner than a cell are where they were") {
  for (const double thickness : {0.2, 0.05, 0.025}) {
    CAPTURE(thickness);
    const TriangleMesh mesh = plate(thickness * kSpacing, 0);
    const Solid coarse = solidWithin(mesh, 0), fine = solidWithin(mesh, kEnough);
    CHECK(farthest(mesh, coarse) > 0.3 * kSpacing);
    CHECK(farthest(mesh, fine) < 0.1 * kSpacing);
    CHECK(inspectMesh(fine.mesh).eulerCharacteristic == 2);
    CHECK(selfIntersections(fine.mesh).empty());
  }
}

TEST_CASE("thin walls: a plate that lies across the lattice takes many planes, as far as allowed") {
  const TriangleMesh mesh = plate(0.4 * kSpacing, 0.3);
  const Solid coarse = solidWithin(mesh, 0), fine = solidWithin(mesh, kEnough);
  CHECK(offset(mesh, fine) < 0.6 * offset(mesh, coarse));
  CHECK(inspectMesh(fine.mesh).eulerCharacteristic == 2);
  CHECK(selfIntersections(fine.mesh).empty());
}

TEST_CASE("thin walls: what is as thick as the cells gets no planes") {
  const TriangleMesh ball = shapes::icosphere(6);
  SolidRule rule{0.1};
  const TriangleMesh before = solidOf(ball, rule).mesh;
  rule.mostPoints = kEnough;
  CHECK(solidOf(ball, rule).mesh.positions == before.positions);
}
