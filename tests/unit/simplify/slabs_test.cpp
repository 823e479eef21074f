// SPDX-License-Identifier: MIT
#include "simplify/slabs.h"

#include <doctest/doctest.h>

#include <cmath>

#include "support/shapes.h"

using namespace remesher;

TEST_CASE("slabs: each triangle is in one, and about equally many are in each") {
  TriangleMesh sheet;
  shapes::addSheet(sheet, 90, 20, [](int i, int k) { return Vec3(0.1 * k, 0.1 * i, 0); });
  sheet.positions.push_back({1e9, 0, 0});  // makes x the longest side of the box
  sheet.indices.insert(sheet.indices.end(), {0, 1, Index(sheet.positions.size() - 1)});
  const Slabs slabs(sheet, 4);
  std::vector<int> counts(sheet.triangleCount(), 0);
  for (std::size_t slab = 0; slab < 4; ++slab) {
    const std::vector<Index> triangles = slabs[slab];
    CHECK(std::abs(double(triangles.size()) - double(counts.size()) / 4) < 50);
    for (const Index t : triangles) ++counts[t];
  }
  for (const int count : counts) CHECK(count == 1);
}
