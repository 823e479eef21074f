// SPDX-License-Identifier: MIT
// A mesh cut into slabs across its longest side, its triangles whole, for work that takes too much
// memory on all of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/triangle_mesh.h"

namespace remesher {

class Slabs {
 public:
  // About equally many triangles in each of `count` slabs, 1 to 256. mesh has triangles.
  Slabs(const TriangleMesh& mesh, std::size_t count);

  // The numbers of the slab's triangles, ascending. Each triangle is in one slab.
  std::vector<Index> operator[](std::size_t slab) const;

 private:
  std::vector<std::uint8_t> slabOf_;  // per triangle
};

}  // namespace remesher
