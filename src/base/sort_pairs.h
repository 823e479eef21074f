// SPDX-License-Identifier: MIT
// Sorting for the many short lists that a bucket sort leaves.
#pragma once

#include <algorithm>
#include <span>
#include <utility>

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

}  // namespace remesher
