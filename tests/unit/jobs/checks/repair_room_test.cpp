// SPDX-License-Identifier: MIT
#include "jobs/checks/repair_room.h"

#include <doctest/doctest.h>

#include <optional>
#include <string>

#include "base/error.h"
#include "jobs/bake_run.h"
#include "jobs/operands.h"
#include "support/shapes.h"

using namespace remesher;

namespace {

std::vector<io::Part> balls(int count) {
  return std::vector<io::Part>(std::size_t(count), {"", shapes::icosphere(5), {}});
}

}  // namespace

TEST_CASE("repair room: what has none is said in numbers of this model") {
  const double triangles = double(balls(1).front().mesh.triangleCount());
  const double needs = 300 * triangles;
  CHECK(!noRoomForFaults(balls(1), needs));
  CHECK_NOTHROW(requireRoomToRepair(balls(1), needs));
  const std::optional<Warning> lacking = noRoomForFaults(balls(1), needs / 2);
  REQUIRE(lacking);
  CHECK(lacking->code == "FAULTS_NOT_SOUGHT");
  CHECK(lacking->count == std::size_t(triangles));
  const std::string fits = "enough for about " + inMillions(triangles / 2) + " triangles.";
  CHECK(lacking->message.ends_with(fits));
  try {
    requireRoomToRepair(balls(1), needs / 2);
    FAIL("no error");
  } catch (const Error& error) {
    CHECK(error.code == ErrorCode::OutOfMemory);
    CHECK(std::string(error.what()).ends_with(fits));
  }
}

TEST_CASE("repair room: unwrapping what has no room is refused in the same words") {
  const double triangles = double(balls(2).front().mesh.triangleCount());
  CHECK_NOTHROW(requireRoomToUnwrap(balls(2), 1200 * triangles));
  CHECK_THROWS_WITH_AS(requireRoomToUnwrap(balls(2), 600 * triangles),
                       doctest::Contains("To unwrap it takes about"), Error);
}

TEST_CASE("repair room: a Boolean of operands that have no room together is refused") {
  const GivenOperand one{"one", balls(1)};
  const double needs = kCombineBytes * 2 * double(balls(1).front().mesh.triangleCount());
  CHECK_NOTHROW(pairOf({one, one}, Carried::Solid, needs));
  CHECK_THROWS_WITH_AS(pairOf({one, one}, Carried::Solid, needs / 2),
                       doctest::Contains("The two models have 1000 triangles. To combine them "
                                         "takes about"),
                       Error);
}

TEST_CASE("repair room: parts are repaired one after the other") {
  const double one = 300 * double(balls(1).front().mesh.triangleCount());
  CHECK(noRoomForFaults(balls(3), one));
  CHECK(!noRoomForFaults(balls(3), 2 * one));
}
