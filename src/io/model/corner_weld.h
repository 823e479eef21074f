// SPDX-License-Identifier: MIT
// Gives all corners at one place one vertex. Places are equal bit by bit, except that -0 equals 0.
#pragma once

#include <vector>

#include "base/types.h"

namespace remesher::io {

class CornerWeld {
 public:
  CornerWeld() = default;
  // With room for the vertices of a closed surface of so many triangles. Growing would take twice
  // the memory.
  explicit CornerWeld(std::size_t triangles);

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
