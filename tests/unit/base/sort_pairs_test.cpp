// SPDX-License-Identifier: MIT
#include "base/sort_pairs.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "support/soups.h"

using namespace remesher;

TEST_CASE("sort_pairs: buckets as std::sort, whether few share a first key or many do") {
  using Item = std::array<Index, 3>;
  soups::Random random(4);
  for (const Index keys : {Index{1}, Index{7}, Index{5000}}) {
    std::vector<Item> items;
    for (Index i = 0; i < 400; ++i) {
      const Vec3 p = 0.5 * (random.point() + Vec3::Ones());
      items.push_back({std::min(keys - 1, Index(p.x() * keys)), Index(9 * p.y()), i});
    }
    std::vector<Item> expected = items;
    std::sort(expected.begin(), expected.end());
    sortInBuckets(
        items, keys, [](const Item& item) { return item[0]; },
        [](const Item& a, const Item& b) { return a < b; });
    CHECK(items == expected);
  }
}
