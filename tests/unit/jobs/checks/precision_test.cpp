// SPDX-License-Identifier: MIT
// A result has as many digits as what it was made of, and what falls together by that is counted.
#include "jobs/checks/precision.h"

#include <doctest/doctest.h>

#include "support/shapes.h"

using namespace remesher;

namespace {

const Vec3 kFine(0.1, 1e-9, 1.0 / 3);

TriangleMesh triangleAt(const Vec3& corner) {
  TriangleMesh mesh;
  mesh.positions = {corner, {1, 0, 0}, {0, 1, 0}};
  mesh.indices = {0, 1, 2};
  return mesh;
}

}  // namespace

TEST_CASE("precision: single stays single, double stays double") {
  TriangleMesh original = triangleAt({0, 0, 0});
  CHECK(inPrecisionOf(original, triangleAt(kFine)).mesh.positions[0] == kFine);
  original.isSingle = true;
  const RoundedMesh rounded = inPrecisionOf(original, triangleAt(kFine));
  CHECK(rounded.mesh.positions[0] == Vec3(0.1F, 1e-9F, 1.0F / 3));
  CHECK(rounded.coincident == 0);
}

TEST_CASE("precision: the smallest numbers, brought to unit size, keep the few digits they have") {
  TriangleMesh original = triangleAt({0, 0, 0});
  original.isSingle = true;
  original.frame.unit = 0x1p+147;  // that of the least number is a quarter
  const RoundedMesh rounded = inPrecisionOf(original, triangleAt({0.3, 0.7, 0.1}));
  CHECK(rounded.mesh.positions[0] == Vec3(0.25, 0.75, 0));
  CHECK(rounded.coincident == 0);
  CHECK(inPrecisionOf(original, triangleAt({0.9, 0.1, 0})).coincident == 1);
}

TEST_CASE("precision: what is left of zero beside the middle that is added is nothing") {
  TriangleMesh original = triangleAt({0, 0, 0});
  const Vec3 nearZero(0.7, -0.3 + 0x1p-54, 0x1p-54);
  original.frame.middle = {0.5, 0.3, 0};
  REQUIRE(original.frame.written(nearZero).y() != 0);
  const Vec3 here = inPrecisionOf(original, triangleAt(nearZero)).mesh.positions[0];
  CHECK(original.frame.written(here) == Vec3(0.7 + 0.5, 0, 0x1p-54));
}

TEST_CASE("precision: places that become one are counted") {
  TriangleMesh original = triangleAt({0, 0, 0});
  original.isSingle = true;
  CHECK(inPrecisionOf(original, triangleAt({1 + 1e-12, 0, 0})).coincident == 1);
}

TEST_CASE("precision: what counts as one place has the same coordinates") {
  // The rounding of a full turn, in a small part of a large model.
  TriangleMesh noisy = triangleAt({1, -2.4e-16, 0.5});
  noisy.positions.emplace_back(1, 0, 0.5);
  noisy.positions.emplace_back(2, 1, 0);
  noisy.indices.insert(noisy.indices.end(), {3, 1, 4, 0, 3, 2});  // whose corners are one place
  const TriangleMesh written = inPrecisionOf(noisy, noisy).mesh;
  CHECK(written.positions[0] == written.positions[3]);
}
