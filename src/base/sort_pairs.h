// SPDX-License-Identifier: MIT
// Bucket sort, and sorting of the many short lists that it leaves.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "base/types.h"

namespace remesher {

// Ascending by the first number, then by the second; insertion sort for a short list.
inline void sortPairs(std::span<std::pair<Index, Index>> pairs) {
  constexpr std::size_t kMany = 16;
  if (pairs.size() > kMany) return std::sort(pairs.data(), pairs.data() + pairs.size());
  for (std::size_t i = 1; i < pairs.size(); ++i) {
    const std::pair<Index, Index> pair = pairs[i];
    std::size_t k = i;
    for (; k > 0 && pair < pairs[k - 1]; --k) pairs[k] = pairs[k - 1];
    pairs[k] = pair;
  }
}

// The numbers from 0 on by ascending keys, which are below `count`; stable.
inline std::vector<Index> orderByKeys(std::span<const Index> keys, std::size_t count) {
  std::vector<Index> starts(count + 1, 0), order(keys.size());
  for (const Index key : keys) ++starts[std::size_t{key} + 1];
  for (std::size_t key = 0; key < count; ++key) starts[key + 1] += starts[key];
  for (Index i = 0; i < order.size(); ++i) order[starts[keys[i]]++] = i;
  return order;
}

// A counting sort by the first key, then short sorts of what shares it. keyOf: below `keys`;
// isBefore: ascends by it first, and tells any two items apart.
template <class Item, class KeyOf, class IsBefore>
void sortInBuckets(std::vector<Item>& items, std::size_t keys, KeyOf keyOf, IsBefore isBefore) {
  std::vector<Index> starts(keys + 1, 0);
  for (const Item& item : items) ++starts[std::size_t{keyOf(item)} + 1];
  for (std::size_t key = 0; key < keys; ++key) starts[key + 1] += starts[key];
  std::vector<Index> next(starts.begin(), starts.end() - 1);
  std::vector<Item> sorted(items.size());
  for (const Item& item : items) sorted[next[keyOf(item)]++] = item;
  for (std::size_t key = 0; key < keys; ++key)
    if (starts[key + 1] - starts[key] > 1)
      std::sort(sorted.begin() + std::ptrdiff_t(starts[key]),
                sorted.begin() + std::ptrdiff_t(starts[key + 1]), isBefore);
  items = std::move(sorted);
}

}  // namespace remesher
