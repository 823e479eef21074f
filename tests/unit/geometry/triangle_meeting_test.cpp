// SPDX-License-Identifier: MIT
#include "geometry/triangle_meeting.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace remesher;

namespace {

// With axes changed in their cycle.
NamedTriangle named(const Triangle& at, Index first, Eigen::Index shift) {
  NamedTriangle result{{first, first + 1, first + 2}, {}};
  for (std::size_t k = 0; k < 3; ++k)
    for (Eigen::Index axis = 0; axis < 3; ++axis) result.at[k][(axis + shift) % 3] = at[k][axis];
  return result;
}

}  // namespace

TEST_CASE("triangle meeting: a long needle meets in its plane what it touches, nothing else") {
  const Triangle beside{Vec3(-2, 1, 0), Vec3(-1, 1, 0), Vec3(-1, 1, 1)},
      at{Vec3(-2, 1, 0), Vec3(1.5, 1, 0.75), Vec3(-1, 1, 1)};
  for (int power = 0; power <= 120; power += 8)
    for (const double scale : {1.0, std::ldexp(1.0, -power)})
      for (Eigen::Index shift = 0; shift < 3; ++shift) {
        const Triangle needle{scale * Vec3(1.25, 1, std::ldexp(1.0, power)),
                              scale * Vec3(1.5, 1, 0.5), scale * Vec3(1.5, 1, 1)};
        const auto scaled = [scale](Triangle t) {
          for (Vec3& p : t) p *= scale;
          return t;
        };
        CAPTURE(power);
        CAPTURE(scale);
        const NamedTriangle own = named(needle, 0, shift);
        CHECK(hasArea(own.at));
        CHECK_FALSE(trianglesMeet(own, named(scaled(beside), 3, shift)));
        CHECK_FALSE(trianglesMeet(named(scaled(beside), 3, shift), own));
        CHECK(trianglesMeet(own, named(scaled(at), 3, shift)));
        CHECK(trianglesMeet(named(scaled(at), 3, shift), own));
      }
}
