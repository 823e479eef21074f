// SPDX-License-Identifier: MIT
#include "geometry/distance_sampler.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/random.h"
#include "support/soups.h"

using namespace remesher;
using doctest::Approx;

TEST_CASE("distance sampler: the largest distance and the mean square are those of the points") {
  const TriangleMesh ball = soups::sphere(12);
  const TriangleTree tree(ball.positions, ball.indices);
  DistanceSampler sampler(tree);
  Random random(5);
  double farthest = 0, sum = 0, weights = 0;
  for (int i = 0; i < 100; ++i) {
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    const double weight = random.uniform();
    const double squared = tree.nearest(Vec3(x, y, z)).squaredDistance;
    CHECK(sampler.add(Vec3(x, y, z), weight) == Approx(squared));
    farthest = std::max(farthest, squared);
    sum += weight * squared;
    weights += weight;
  }
  CHECK(sampler.squaredFarthest() == Approx(farthest));
  CHECK(sampler.farthest() == Approx(std::sqrt(farthest)));
  CHECK(sampler.rms() == Approx(std::sqrt(sum / weights)));
  CHECK(sampler.meanSquare() == Approx(sum / weights));
}

TEST_CASE("distance sampler: points near enough count as no farther, others in the maximum only") {
  const TriangleMesh ball = soups::sphere(12);
  const TriangleTree tree(ball.positions, ball.indices);
  DistanceSampler sampler(tree);
  CHECK(sampler.rms() == 0);
  CHECK(sampler.near() == kNone);
  const Vec3 out(0.3, 0.4, 3);
  CHECK(sampler.addBeyond(0.5, out) == tree.nearest(out).squaredDistance);
  CHECK(sampler.rms() == sampler.farthest());
  CHECK(sampler.near() < ball.triangleCount());
  const double squared = sampler.addBeyond(sampler.farthest(), Vec3(0, 0, 2));
  CHECK(squared <= sampler.squaredFarthest());
  CHECK(sampler.farthest() == std::sqrt(tree.nearest(out).squaredDistance));
  sampler.add(Vec3(0, 0, 2));
  CHECK(sampler.rms() == Approx(std::sqrt(tree.nearest(Vec3(0, 0, 2)).squaredDistance)));
}
