// SPDX-License-Identifier: MIT
#include "arrangement/parted_fans.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace remesher;

TEST_CASE("parted fans: fans that cannot be parted leave everything as it was") {
  ArrangementInput input;
  input.positions = {{0, 0, 1},  {3, 0, 0},   {2, 2, 0},  {0, 3, 0}, {-2, 2, 0},
                     {-3, 0, 0}, {-2, -2, 0}, {0, -3, 0}, {2, -2, 0}};
  ArrangementResult given;
  given.positions = input.positions;
  for (Index i = 0; i < 8; ++i) {
    input.indices.insert(input.indices.end(), {0, 1 + i, 1 + (i + 1) % 8});
    const Index last = i % 4 < 3 ? i + 1 : i - 3;  // two fans of four
    given.indices.insert(given.indices.end(), {0, 1 + i, 1 + last});
    given.triangles.push_back({i, false, {}, last > i});
  }
  const auto parted = [&](const std::vector<Index>& crossings) {
    ArrangementResult result = given;
    partFans(
        result, input,
        {[](const Vec3& p) { return p; }, [&](const ArrangementResult&) { return crossings; }});
    return result;
  };
  const auto untouchedIn = [](const ArrangementResult& result) {
    return std::count_if(result.triangles.begin(), result.triangles.end(),
                         [](const ArrangedTriangle& t) { return t.isUntouched; });
  };
  const ArrangementResult left = parted({0, 1, 2, 3, 4, 5, 6, 7});
  CHECK(left.positions == given.positions);
  CHECK(left.indices == given.indices);
  CHECK(left.selfIntersections.empty());
  CHECK(untouchedIn(left) == 6);
  CHECK(parted({}).positions.size() == given.positions.size() + 1);
  CHECK(untouchedIn(parted({})) == 3);
}
