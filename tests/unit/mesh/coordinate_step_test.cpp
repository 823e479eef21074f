// SPDX-License-Identifier: MIT
#include "mesh/coordinate_step.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "support/shapes.h"

using namespace remesher;

namespace {

std::vector<Vec3> inSteps(std::vector<Vec3> positions, double step) {
  for (Vec3& p : positions)
    for (double& x : p) x = std::round(x / step) * step;
  return positions;
}

std::vector<Vec3> moved(std::vector<Vec3> positions, const Vec3& by) {
  for (Vec3& p : positions) p += by;
  return positions;
}

const std::vector<Vec3> kBall = shapes::icosphere(8).positions;  // radius 1

}  // namespace

TEST_CASE("coordinate step: digits that a file leaves out are noise, wherever it is") {
  for (const double step : {1e-4, 1e-5, 0x1p-14})
    for (const Vec3& by : {Vec3(0, 0, 0), Vec3(0, 40, -8), Vec3(64, 64, 0)})
      CHECK(coordinateStep(moved(inSteps(kBall, step), by)) == doctest::Approx(step));
}

TEST_CASE("coordinate step: without such digits it is a share of the size, not of the distance") {
  const double own = coordinateStep(kBall);
  CHECK(own == doctest::Approx(kSingleRoundOff));
  CHECK(coordinateStep(moved(kBall, {0, 2, 0})) == doctest::Approx(own));
}

TEST_CASE("coordinate step: what few digits describe exactly is no noise") {
  for (const double side : {1.0, 10.0, 1e6}) {
    std::vector<Vec3> box = shapes::cube(2).positions;
    for (Vec3& p : box) p *= side / 2;
    CHECK(coordinateStep(box) <= 0x1p-13 * side);
  }
  // Fine arcs drawn out along an axis of two whole numbers.
  std::vector<Vec3> drum;
  for (const double z : {0.0, 10.0})
    for (int k = 0; k < 720; ++k) drum.push_back(5 * shapes::onCircle(k, 720) + Vec3(0, 0, z));
  CHECK(coordinateStep(drum) < 1e-5);
}

TEST_CASE("coordinate step: the few roundings of single precision far away are noise") {
  std::vector<Vec3> far = moved(kBall, {1e5, 0, 0});
  for (Vec3& p : far) p = p.cast<float>().cast<double>();
  CHECK(coordinateStep(far) > 1e5 * 0x1p-24);
}
