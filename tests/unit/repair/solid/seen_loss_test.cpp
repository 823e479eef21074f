// SPDX-License-Identifier: MIT
#include "repair/solid/seen_loss.h"

#include <doctest/doctest.h>

#include "repair/solid/solid.h"
#include "support/hostile_shapes.h"
#include "support/shapes.h"
#include "support/soups.h"

using namespace remesher;

namespace {

TriangleMesh box(const Vec3& low, const Vec3& high) {
  TriangleMesh mesh = soups::cube(0, 1);
  for (Vec3& p : mesh.positions) p = low + p.cwiseProduct(high - low);
  return mesh;
}

}  // namespace

TEST_CASE("seen loss: what is kept loses nothing, hidden shells count for nothing") {
  const TriangleMesh ball = shapes::icosphere(6);
  TriangleMesh inner = ball;
  for (Vec3& p : inner.positions) p *= 0.5;
  for (const TriangleMesh& mesh : {ball, soups::joined({ball, inner}), soups::cube(0, 2)}) {
    const Solid solid = solidOf(mesh, {0.08});
    CHECK(solid.loss.share == 0);
    CHECK(solid.loss.places.empty());
    CHECK(solid.loss.beyond == doctest::Approx(0.08));
  }
}

TEST_CASE("seen loss: sheets that are dropped are lost, in proportion to their area") {
  const double side = 2;
  for (const double length : {1.0, 3.0}) {
    TriangleMesh sheet;
    const Vec3 low(4, 4.05, 4.03), along(0.6 * length, 0.8 * length, 0), up(0, 0, 1);
    soups::addQuad(sheet, {low, low + along, low + along + up, low + up});
    SolidRule rule{0.1, InsideBy::Reach, 0.3};
    rule.sheets = Sheets::Drop;
    const Solid solid = solidOf(soups::joined({box({0, 0, 0}, {side, side, side}), sheet}), rule);
    const double all = 6 * side * side + length;
    CHECK(solid.loss.share == doctest::Approx(100 * length / all).epsilon(0.1));
    REQUIRE(!solid.loss.places.empty());
    for (const Vec3& place : solid.loss.places) CHECK(place.x() >= 4);
  }
}

TEST_CASE("seen loss: nothing of a sheet that is given from both sides") {
  for (const double apart : {0.0, 0.02, 0.04}) {
    const TriangleMesh up = shapes::grid(3, 2);
    const TriangleMesh down = soups::moved(shapes::turnedOver(up), Vec3(0, 0, -apart));
    const Solid solid = solidOf(soups::joined({up, down}), {0.1, InsideBy::Reach, 0.3});
    CHECK(solid.enclosure.sheets == 2);
    CHECK(solid.loss.share == 0);
  }
}

TEST_CASE("seen loss: the bottom of a slot that is wrapped over is lost, its rim is not") {
  // A block with a slot along y, 0.1 wide and 0.8 deep.
  const TriangleMesh slotted =
      soups::joined({box({0, 0, 0}, {1, 2, 0.2}), box({0, 0, 0.1}, {0.45, 2, 1}),
                     box({0.55, 0, 0.1}, {1, 2, 1})});
  const Solid narrow = solidOf(slotted, {0.02, InsideBy::Reach, 0.06});
  const Solid wide = solidOf(slotted, {0.02, InsideBy::Reach, 0.15});
  CHECK(narrow.loss.share < 0.2);
  CHECK(wide.loss.share > 1);
  REQUIRE(!wide.loss.places.empty());
  CHECK(wide.loss.places.front().z() == doctest::Approx(0.2).epsilon(0.05));
}
