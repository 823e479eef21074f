// SPDX-License-Identifier: MIT
#include "repair/seen_share.h"

#include <doctest/doctest.h>

#include <numeric>
#include <vector>

#include "support/hostile_shapes.h"
#include "support/shapes.h"
#include "support/soups.h"

using namespace remesher;

TEST_CASE("seen share: of bodies that are dropped those count that are seen") {
  const TriangleMesh ball = shapes::icosphere(4), beside = soups::moved(ball, {3, 0, 0}),
                     within = shapes::scaled(ball, 0.5);
  std::vector<Index> parents(ball.triangleCount());
  std::iota(parents.begin(), parents.end(), Index{0});
  const double lost = seenShareLost(soups::joined({ball, beside}), ball, parents);
  CHECK(lost > 0.4);  // a few lines of sight do not find what lies between the balls
  CHECK(lost <= 0.5);
  CHECK(seenShareLost(soups::joined({ball, within}), ball, parents) == 0);
  CHECK(seenShareLost(soups::joined({ball, ball}), ball, parents) == 0);  // given twice
}
