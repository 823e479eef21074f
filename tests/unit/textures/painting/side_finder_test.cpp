// SPDX-License-Identifier: MIT
#include "textures/painting/side_finder.h"

#include <doctest/doctest.h>

#include "textures/painting/squares.h"

using namespace remesher;

using namespace remesher::test;

TEST_CASE("side_finder: of sheets that touch each finds its own") {
  TriangleMesh mesh;
  addSquare(mesh, 0, Facing::Up);       // 0, 1
  addSquare(mesh, 1e-3, Facing::Up);    // 2, 3: just above, not joined
  addSquare(mesh, 5e-4, Facing::Down);  // 4, 5: between, facing down
  const auto source = sourceOf(mesh);
  SideFinder finder(*source);
  const auto found = [&](Index number, double z) {
    const InputTriangle first(number);
    finder.enter({{Vec3(0.1, 0.1, 0), Vec3(0.9, 0.1, 0), Vec3(0.9, 0.9, 0)},
                  {InputPlace{first, {1, 0, 0}}, {first, {0, 1, 0}}, {first, {0, 0, 1}}}});
    return finder.find(Vec3(0.6, 0.4, 1e-4), Vec3(0, 0, z)).triangle.index;
  };
  CHECK(found(0, 1) == 0);
  CHECK(found(2, 1) == 2);
  CHECK(found(4, -1) / 2 == 2);
}

TEST_CASE("side_finder: along the normal, not to the nearest") {
  // A step: low for x < 1, high beyond, with a wall between.
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                    {1, 0, 1}, {1, 1, 1}, {2, 0, 1}, {2, 1, 1}};
  mesh.indices = {0, 1, 2, 0, 2, 3, 1, 5, 2, 1, 4, 5, 4, 6, 7, 4, 7, 5};
  const auto source = sourceOf(mesh);
  SideFinder finder(*source);
  finder.enter({{Vec3(0, 0, 0.5), Vec3(2, 0, 0.5), Vec3(2, 1, 0.5)},
                {InputPlace{InputTriangle(0), {1, 0, 0}},
                 {InputTriangle(4), {0, 1, 0}},
                 {InputTriangle(4), {0, 0, 1}}}});
  const InputPlace place = finder.find(Vec3(0.9, 0.5, 0.5), Vec3::UnitZ());
  CHECK(place.triangle.index < 2);
  CHECK((source->position(place) - Vec3(0.9, 0.5, 0)).norm() < 1e-12);
}

TEST_CASE("side_finder: on one sheet it is all the same what was asked for before") {
  TriangleMesh mesh;
  constexpr Index kSide = 6;
  for (Index i = 0; i < (kSide + 1) * (kSide + 1); ++i)
    mesh.positions.emplace_back(i % (kSide + 1), i / (kSide + 1), 0.1 * (i % 3));
  for (Index y = 0; y < kSide; ++y)
    for (Index x = 0; x < kSide; ++x) {
      const Index a = y * (kSide + 1) + x, b = a + kSide + 1;
      for (const Index v : {a, a + 1, b + 1, a, b + 1, b}) mesh.indices.push_back(v);
    }
  const auto source = sourceOf(mesh);
  const NewTriangle all{{Vec3(0, 0, 0), Vec3(6, 0, 0), Vec3(6, 6, 0)},
                        {InputPlace{InputTriangle(0), {1, 0, 0}},
                         {InputTriangle(10), {0, 1, 0}},
                         {InputTriangle(70), {0, 1, 0}}}};
  SideFinder walking(*source);
  walking.enter(all);
  for (int i = 0; i < 600; ++i) {
    const Vec3 point(0.05 + 0.1 * (37 * i % 59), 0.05 + 0.1 * (23 * i % 58), 0);
    SideFinder fresh(*source);
    fresh.enter(all);
    const InputPlace place = walking.find(point, Vec3::UnitZ());
    const Vec3 found = source->position(place);
    CHECK((found - source->position(fresh.find(point, Vec3::UnitZ()))).norm() < 1e-9);
    CHECK((found - point).head<2>().norm() < 1e-9);
  }
}
