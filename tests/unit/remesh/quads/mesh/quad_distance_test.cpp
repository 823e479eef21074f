// SPDX-License-Identifier: MIT
#include "remesh/quads/mesh/quad_distance.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "remesh/quads/mesh/quad_parts.h"
#include "remesh/quads/quad_sizes.h"
#include "remesh/quads/quads.h"
#include "support/working_meshes.h"

using namespace remesher;

TEST_CASE("quad_distance: quads that follow a ball are near, those that leave it in part are not") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::icosphere(9));
  const WorkingMesh ball(surface);
  const QuadDistance distance(ball);
  const OriginalDistance original(ball);
  WorkBudget work;
  const QuadMesh quads = mapToQuads(ball, 200, evenSizes, work);
  REQUIRE_FALSE(quads.quads.empty());
  CHECK(distance.sidesAway(quads) == 0);
  CHECK(original.farthest(quads) < 0.1);
  const double side = std::sqrt(4 * std::numbers::pi / double(quads.quads.size()));

  QuadMesh half = quads;
  std::vector<char> isBelow;
  for (const Four<Index>& quad : half.quads) isBelow.push_back(half.position(quad[0]).z() < 0);
  dropQuads(half, isBelow);
  CHECK(distance.sidesAway(half) > 0.9 / side);
  CHECK(distance.quadsAway(half) == 0);
  CHECK(original.farthest(half) > 0.9);

  QuadMesh across = quads;  // with one more, through the middle of the ball
  const auto farthestTo = [&](const Vec3& direction) {
    Index best = 0;
    for (Index v = 1; v < quads.vertices.size(); ++v)
      if (quads.position(v).dot(direction) > quads.position(best).dot(direction)) best = v;
    return best;
  };
  across.quads.push_back({farthestTo(Vec3::UnitX()), farthestTo(Vec3::UnitY()),
                          farthestTo(-Vec3::UnitX()), farthestTo(-Vec3::UnitY())});
  CHECK(distance.sidesAway(across) > 0.8 / side);
  CHECK(distance.quadsAway(across) > 0.8 / side);
  CHECK(original.farthest(across) > 0.8);
}
