// SPDX-License-Identifier: MIT
#include "remesh/symmetry/mirrored_guides.h"

#include <doctest/doctest.h>

using namespace remesher;

namespace {

const Mirrors kLeftRight = {{{Vec3::UnitX(), 0}}, 1e-9, 100};

Guide square(double x) {
  return {{{x - 1, 0, 0}, {x + 1, 0, 0}, {x + 1, 2, 0}, {x - 1, 2, 0}},
          GuideKind::Loop,
          true,
          "square"};
}

}  // namespace

TEST_CASE("mirrored guides: what lies behind the plane is mirrored, once") {
  const GuidesOfHalf half = guidesInFront({square(-5)}, kLeftRight, 0.1);
  REQUIRE(half.guides.size() == 1);
  CHECK(half.moved == 1);
  CHECK(half.guides[0].isClosed);
  CHECK(half.guides[0].points[0] == Vec3(6, 0, 0));
  const GuidesOfHalf twice = guidesInFront({square(5), square(-5)}, kLeftRight, 0.1);
  CHECK(twice.guides.size() == 1);
  CHECK(guidesInFront({square(5)}, kLeftRight, 0.1).moved == 0);
}

TEST_CASE(
    "mirrored guides: of a closed one across the plane the longer side stays, from plane to "
    "plane") {
  for (const double x : {0.25, -0.25, 0.0}) {
    const GuidesOfHalf half = guidesInFront({square(x)}, kLeftRight, 0.1);
    REQUIRE(half.guides.size() == 1);
    const Guide& made = half.guides[0];
    CHECK(half.moved == 1);
    CHECK_FALSE(made.isClosed);
    CHECK(made.points.front().x() == 0);
    CHECK(made.points.back().x() == 0);
    for (const Vec3& p : made.points) CHECK(p.x() >= 0);
    CHECK(made.points[1].x() == doctest::Approx(1 + std::abs(x)));
  }
}

TEST_CASE("mirrored guides: one along a plane is left out, for sides of quads lie there anyway") {
  for (const double away : {1e-4, 0.04}) {
    Guide along{
        {{away, 0, 0}, {-away, 1, 0}, {away, 1, 1}, {-away, 0, 1}}, GuideKind::Loop, true, "along"};
    const GuidesOfHalf half = guidesInFront({along, square(5)}, kLeftRight, 0.1);
    REQUIRE(half.guides.size() == 1);
    CHECK(half.guides[0].name == "square");
    CHECK(half.moved == 1);
    along.points[0].x() = 0.07;
    CHECK(guidesInFront({along}, kLeftRight, 0.1).guides.size() == 1);
  }
}
