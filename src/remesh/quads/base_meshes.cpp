// SPDX-License-Identifier: MIT
#include "remesh/quads/base_meshes.h"

#include <algorithm>

#include "remesh/quads/field/sectors.h"
#include "remesh/quads/mesh/quad_parts.h"

namespace remesher {

namespace {

WorkingMesh opened(WorkingMesh mesh, const Mirrors& mirrors) {
  openSectors(mesh, mirrors);
  return mesh;
}

}  // namespace

BaseMeshes::BaseMeshes(const TriangleMaker& triangles, std::size_t first, std::size_t second,
                       const Mirrors& mirrors)
    : triangles_(triangles),
      mirrors_(mirrors),
      count_(first),
      second_(second),
      first_(opened(triangles(first), mirrors_)),
      numbers_(partNumbers(first_.surface().mesh())),
      levels_{connectedParts(first_)} {}

const WorkingMesh* BaseMeshes::part(std::size_t level, Index number) {
  while (level >= levels_.size()) {
    if (count_ <= second_) return nullptr;
    count_ = second_;
    levels_.push_back(connectedParts(opened(triangles_(count_), mirrors_)));
  }
  for (const WorkingMesh& part : levels_[level])
    if (numbers_[part.at(Vertex(0)).face] == number) return &part;
  return nullptr;
}

}  // namespace remesher
