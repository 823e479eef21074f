// SPDX-License-Identifier: MIT
#include "remesh/quads/extract/closing.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "support/working_meshes.h"

using namespace remesher;

namespace {

constexpr int kSide = 48;

// A square whose lower side goes up and down by `high` from each vertex to the next.
OriginalSurface jaggedSquare(double high, double size) {
  TriangleMesh square;
  shapes::addSheet(square, kSide, kSide, [&](int x, int y) {
    return Vec3(x, y == 0 && x % kSide != 0 ? (x % 2 == 0 ? high : -high) : y, 0);
  });
  BuiltMesh built = buildMesh(square);
  CurveRules rules;
  rules.size = size;
  FeatureCurves curves(built.mesh, built.positions, rules);
  return OriginalSurface(std::move(built), std::move(curves));
}

}  // namespace

TEST_CASE("closing: a border that zigzags becomes smooth, and stays near") {
  constexpr double kSize = 4;
  const OriginalSurface surface = jaggedSquare(0.6, kSize);
  const WorkingMesh ground(surface);
  WorkingMesh smooth = ground;
  smoothBorders(smooth, kSize);
  const auto lowerSide = [](const WorkingMesh& mesh) {
    double length = 0;
    for (Index i = 0; i < mesh.mesh().halfedgeCapacity(); ++i)
      if (mesh.mesh().isBoundary(Halfedge(i))) length += mesh.edgeLength(Halfedge(i));
    return length - 3 * kSide;
  };
  CHECK(lowerSide(ground) > 1.2 * kSide);
  CHECK(lowerSide(smooth) < 1.1 * kSide);
  double farthest = 0;
  for (Index i = 0; i < ground.positions().size(); ++i)
    farthest = std::max(farthest, (smooth.position(Vertex(i)) - ground.position(Vertex(i))).norm());
  CHECK(farthest < 0.2 * kSize);
}

TEST_CASE("closing: borders that bend by less than 45 degrees stay in place") {
  const OriginalSurface surface = jaggedSquare(0.2, 4);
  const WorkingMesh ground(surface);
  WorkingMesh smooth = ground;
  smoothBorders(smooth, 4);
  CHECK(smooth.positions().values() == ground.positions().values());
}
