// SPDX-License-Identifier: MIT
// Disjoint sets of numbers that only merge: union and find.
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "base/types.h"

namespace remesher {

class DisjointSets {
 public:
  // At first each number below `size` is a set of its own.
  explicit DisjointSets(std::size_t size) : parents_(size) {
    std::iota(parents_.begin(), parents_.end(), Index{0});
  }

  // The set's name: its lowest member.
  Index find(Index x) {
    while (parents_[x] != x) x = parents_[x] = parents_[parents_[x]];
    return x;
  }

  // Merges two sets; false if they were one already.
  bool unite(Index x, Index y) {
    x = find(x), y = find(y);
    parents_[std::max(x, y)] = std::min(x, y);
    return x != y;
  }

 private:
  std::vector<Index> parents_;
};

}  // namespace remesher
