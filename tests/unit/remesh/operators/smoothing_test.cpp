// SPDX-License-Identifier: MIT
#include "remesh/operators/smoothing.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "mesh/mesh_builder.h"
#include "support/shapes.h"
#include "support/soups.h"

using namespace remesher;

namespace {

// A planar star: n rim vertices around vertex 0 at the origin, convex enough to hold p below.
BuiltMesh star(int n, soups::Random& random) {
  TriangleMesh mesh;
  shapes::addVertex(mesh, Vec3::Zero());
  for (int k = 0; k < n; ++k)
    shapes::addVertex(mesh, (1 + random.number()) * shapes::onCircle(k, n));
  for (Index k = 0; k < Index(n); ++k) shapes::addTriangle(mesh, 0, 1 + k, 1 + (k + 1) % Index(n));
  return buildMesh(mesh);
}

std::vector<double> areas(const PolarMap& map, const Vec2& p) {
  std::vector<double> result;
  for (int i = 0; i < map.size(); ++i) {
    const Vec2 a = map.rim(i) - p, b = map.rim(map.after(i)) - p;
    result.push_back(0.5 * (a.x() * b.y() - a.y() * b.x()));
  }
  return result;
}

}  // namespace

TEST_CASE("smoothing: areas that one place gives are asked for and found there") {
  soups::Random random(41);
  for (int n = 3; n < 12; ++n) {
    CAPTURE(n);
    const BuiltMesh built = star(n, random);
    PolarMap map;
    map.build(built.mesh, built.positions, Vertex(0));
    const Vec2 place = 0.5 * (random.point() - Vec3::Constant(0.5)).head<2>();
    CHECK((areaBasedTarget(map, areas(map, place)) - place).norm() < 1e-9);
  }
}

TEST_CASE("smoothing: no place nearby comes closer to equal areas") {
  soups::Random random(42);
  const BuiltMesh built = star(7, random);
  PolarMap map;
  map.build(built.mesh, built.positions, Vertex(0));
  const auto error = [&](const Vec2& p) {
    const std::vector<double> now = areas(map, p);
    double total = 0, sum = 0;
    for (const double a : now) total += a;
    for (const double a : now) sum += (a - total / 7) * (a - total / 7);
    return sum;
  };
  const Vec2 target = areaBasedTarget(map, std::vector<double>(7, 2.5));
  for (int k = 0; k < 16; ++k) {
    const Vec2 away = 1e-3 * shapes::onCircle(k, 16).head<2>();
    CHECK(error(target + away) > error(target));
  }
}

TEST_CASE("smoothing: the Laplacian target is the mean of the rim") {
  soups::Random random(43);
  const BuiltMesh built = star(6, random);
  PolarMap map;
  map.build(built.mesh, built.positions, Vertex(0));
  Vec2 sum = Vec2::Zero();
  for (int i = 0; i < 6; ++i) sum += map.rim(i);
  CHECK((laplacianTarget(map) - sum / 6).norm() < 1e-12);
}

TEST_CASE("smoothing: the middle of a regular star is its own target") {
  TriangleMesh mesh;
  shapes::addVertex(mesh, Vec3::Zero());
  for (int k = 0; k < 6; ++k) shapes::addVertex(mesh, shapes::onCircle(k, 6));
  for (Index k = 0; k < 6; ++k) shapes::addTriangle(mesh, 0, 1 + k, 1 + (k + 1) % 6);
  const BuiltMesh built = buildMesh(mesh);
  PolarMap map;
  map.build(built.mesh, built.positions, Vertex(0));
  CHECK(laplacianTarget(map).norm() < 1e-12);
  CHECK(wideTarget(map).norm() < 1e-12);
  CHECK(areaBasedTarget(map, std::vector<double>(6, 1)).norm() < 1e-12);
}

TEST_CASE("smoothing: of seven triangles beside the middle each gets an angle as wide as can be") {
  TriangleMesh mesh;
  shapes::addVertex(mesh, Vec3(0.1, 0.07, 0));
  for (int k = 0; k < 7; ++k) shapes::addVertex(mesh, shapes::onCircle(k, 7));
  for (Index k = 0; k < 7; ++k) shapes::addTriangle(mesh, 0, 1 + k, 1 + (k + 1) % 7);
  const BuiltMesh built = buildMesh(mesh);
  PolarMap map;
  map.build(built.mesh, built.positions, Vertex(0));
  const auto smallest = [&](const Vec2& p) {
    double angle = 360;
    for (int i = 0; i < map.size(); ++i) {
      const Vec2 a = map.rim(i) - p, b = map.rim(map.after(i)) - p;
      angle = std::min(angle, std::acos(a.dot(b) / (a.norm() * b.norm())) / radians(1));
    }
    return angle;
  };
  CHECK(smallest(Vec2::Zero()) < 48);
  CHECK(smallest(wideTarget(map)) > 50);
}
