// SPDX-License-Identifier: MIT
// The triangle meshes that maps are made on. A map of far more triangles than quads keeps curves
// and fields too fine for the quads and may fail: each further mesh has half as many vertices.
#pragma once

#include <cstddef>
#include <vector>

#include "remesh/quads/quads.h"

namespace remesher {

class BaseMeshes {
 public:
  // The first mesh has so many vertices; no other has fewer than `least`. `triangles` must outlive
  // it.
  BaseMeshes(const TriangleMaker& triangles, std::size_t first, std::size_t least);

  const WorkingMesh& first() const { return first_; }
  const std::vector<WorkingMesh>& parts() const { return levels_.front(); }  // of the first mesh

  // The part of a mesh, 0 for the first, that is on the original's connected part with this number;
  // nullptr if there is no such mesh. It lives until the next call.
  const WorkingMesh* part(std::size_t level, Index number);

 private:
  const TriangleMaker& triangles_;
  std::size_t count_, least_;
  WorkingMesh first_;
  FaceData<Index> numbers_;
  std::vector<std::vector<WorkingMesh>> levels_;
};

}  // namespace remesher
