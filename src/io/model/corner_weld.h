// SPDX-License-Identifier: MIT
// One vertex for all corners at one place: equal bit by bit, but that -0 is 0.
#pragma once

#include <vector>

#include "base/types.h"

namespace remesher::io {

class CornerWeld {
 public:
  // The vertex there, numbered in the order of first mention.
  Index vertexAt(const Vec3& position);

  std::vector<Vec3>& positions() { return positions_; }

 private:
  void grow();
  std::size_t slotOf(const Vec3& position) const;

  std::vector<Vec3> positions_;
  std::vector<Index> slots_;  // a hash table with open addressing; kNone is free
};

}  // namespace remesher::io
