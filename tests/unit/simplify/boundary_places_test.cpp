// SPDX-License-Identifier: MIT
// The law of boundaries: each boundary vertex of a simplified surface lies on a boundary loop of
// the surface that was given, in the same order, so that loops only become shorter.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/triangle.h"
#include "mesh/mesh_builder.h"
#include "simplify/simplify.h"
#include "support/mesh_check.h"
#include "support/shapes.h"

using namespace remesher;

namespace {

// Open at both ends; its rims are waves along and across it.
TriangleMesh vase(int around, int rows, int waves) {
  TriangleMesh mesh;
  shapes::addSheet(mesh, around, rows, [&](int column, int row) {
    const Vec3 p = shapes::onCircle(column, around);
    const double share = double(row) / rows,
                 turn = 2 * std::numbers::pi * (column % around) / around;
    const double radius = 1 + 0.4 * std::sin(4 * share) + 0.2 * share * std::cos(waves * turn);
    return Vec3(radius * p.x(), radius * p.y(),
                3 * share + 0.15 * (1 - share) * std::sin(waves * turn));
  });
  return mesh;
}

TriangleMesh wavedSheet(int side) {
  TriangleMesh mesh = shapes::grid(side, side);
  for (Vec3& p : mesh.positions)
    p = {p.x() + std::sin(p.y() / 3), p.y() + std::sin(p.x() / 2),
         2 * std::sin((p.x() + p.y()) / 4)};
  return mesh;
}

// The edges of boundaries, each from its origin to its tip.
std::vector<Triangle> bordersOf(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions) {
  std::vector<Triangle> result;
  for (Index i = 0; i < mesh.halfedgeCapacity(); ++i)
    if (mesh.isAlive(Halfedge(i)) && mesh.isBoundary(Halfedge(i))) {
      const Vec3 &from = positions[mesh.origin(Halfedge(i))],
                 &to = positions[mesh.tip(Halfedge(i))];
      result.push_back({from, to, to});
    }
  return result;
}

double lengthOf(const std::vector<Triangle>& borders) {
  double sum = 0;
  for (const auto& [from, to, same] : borders) sum += (to - from).norm();
  return sum;
}

double distanceTo(const std::vector<Triangle>& borders, const Vec3& p) {
  double least = 1e300;
  for (const auto& [from, to, same] : borders) {
    const Vec3 way = to - from;
    const double share = std::clamp((p - from).dot(way) / way.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (from + share * way - p).norm());
  }
  return least;
}

}  // namespace

TEST_CASE("simplify: boundary vertices lie on the boundary loops that were given") {
  const std::vector<TriangleMesh> inputs = {vase(48, 20, 3), vase(30, 30, 5), wavedSheet(30),
                                            shapes::grid(20, 20)};
  for (std::size_t shape = 0; shape < inputs.size(); ++shape) {
    CAPTURE(shape);
    const BuiltMesh built = buildMesh(inputs[shape]);
    const std::vector<Triangle> before = bordersOf(built.mesh, built.positions);
    for (const std::size_t vertices : {40, 60, 90, 140, 210, 320}) {
      CAPTURE(vertices);
      SimpleSurface surface{built.mesh, built.positions,
                            HalfedgeData<char>(built.mesh.halfedgeCapacity(), 0)};
      // In two calls, as a caller that counts positions does.
      simplify(surface, 2 * vertices);
      simplify(surface, vertices);
      REQUIRE(surface.mesh.vertexCount() == vertices);
      CHECK(check(surface.mesh) == "");
      const std::vector<Triangle> after = bordersOf(surface.mesh, surface.positions);
      double farthest = 0;
      for (const Triangle& edge : after) farthest = std::max(farthest, distanceTo(before, edge[0]));
      CHECK(farthest < 1e-12);
      CHECK(lengthOf(after) < (1 + 1e-12) * lengthOf(before));
    }
  }
}

TEST_CASE("simplify: round boundary loops become shorter by little more than chords are") {
  const BuiltMesh built = buildMesh(vase(96, 24, 0));
  const std::vector<Triangle> before = bordersOf(built.mesh, built.positions);
  for (const std::size_t vertices : {100, 150, 200, 300}) {
    CAPTURE(vertices);
    SimpleSurface surface{built.mesh, built.positions,
                          HalfedgeData<char>(built.mesh.halfedgeCapacity(), 0)};
    simplify(surface, vertices);
    const std::vector<Triangle> after = bordersOf(surface.mesh, surface.positions);
    // Of two loops, each of half of the edges.
    const double turn = 2 * std::numbers::pi / double(after.size());
    const double lost = 1 - lengthOf(after) / lengthOf(before);
    CHECK(lost < 2 * (1 - std::sin(turn) / turn));
  }
}
