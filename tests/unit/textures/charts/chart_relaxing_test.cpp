// SPDX-License-Identifier: MIT
#include "textures/charts/chart_relaxing.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace remesher;

namespace {

// A sphere's cap out to an angle, in rings of triangles, as a stereographic map lays it down.
PlaneMesh cap(double angle, Index rings) {
  const Index sectors = 2 * rings;
  PlaneMesh mesh{{Vec2::Zero()}, {}, {}};
  std::vector<Vec3> places = {Vec3::UnitZ()};
  for (Index i = 1; i <= rings; ++i)
    for (Index j = 0; j < sectors; ++j) {
      const double a = angle * i / rings, b = 2 * std::numbers::pi * j / sectors;
      const Vec2 way(std::cos(b), std::sin(b));
      places.emplace_back(std::sin(a) * way.x(), std::sin(a) * way.y(), std::cos(a));
      mesh.vertices.push_back(2 * std::tan(a / 2) * way);
    }
  const auto add = [&](Index a, Index b, Index c) {
    mesh.triangles.push_back({a, b, c});
    mesh.wanted.push_back(laidDown(places[a], places[b], places[c]));
  };
  const auto at = [&](Index ring, Index j) { return 1 + (ring - 1) * sectors + j % sectors; };
  for (Index j = 0; j < sectors; ++j) {
    add(0, at(1, j), at(1, j + 1));
    for (Index i = 1; i < rings; ++i) {
      add(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      add(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  return mesh;
}

}  // namespace

TEST_CASE("chart relaxing: what can be laid true is, however finely it is divided") {
  for (const Index rings : {6, 12, 24}) {
    CAPTURE(rings);
    PlaneMesh mesh = cap(1.1, rings);
    CHECK(relax(mesh));
  }
}

TEST_CASE("chart relaxing: most of a sphere cannot be laid true") {
  PlaneMesh mesh = cap(2, 12);
  CHECK_FALSE(relax(mesh));
}
