// SPDX-License-Identifier: MIT
// Gives all corners at one place one vertex. Places are equal bit by bit, except that -0 equals 0.
#pragma once

#include <vector>

#include "base/types.h"

namespace remesher::io {

class CornerWeld {
 public:
  // The vertex at a position; vertices are numbered in the order of first mention.
  Index vertexAt(const Vec3& position);

  std::vector<Vec3>& positions() { return positions_; }

 private:
  void grow();
  std::size_t slotOf(const Vec3& position) const;

  std::vector<Vec3> positions_;
  std::vector<Index> slots_;  // a hash table with open addressing; kNone is free
};

}  // namespace remesher::io
