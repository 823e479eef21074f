// SPDX-License-Identifier: MIT
// The triangle meshes that maps are made on. A map of far more triangles than quads keeps curves
// and fields too fine for the quads and may fail: a second mesh has as many vertices as the quads.
#pragma once

#include <cstddef>
#include <vector>

#include "remesh/quads/quads.h"

namespace remesher {

class BaseMeshes {
 public:
  // The number of vertices of the first mesh, and of the second if that is less. `triangles` must
  // outlive the meshes. mirrors: of a half.
  BaseMeshes(const TriangleMaker& triangles, std::size_t first, std::size_t second,
             const Mirrors& mirrors = {});

  const WorkingMesh& first() const { return first_; }
  const std::vector<WorkingMesh>& parts() const { return levels_.front(); }  // of the first mesh

  // The part of a mesh, 0 for the first, 1 for the second, that is on the original's connected part
  // with this number; nullptr if there is no such mesh. It lives until the next call.
  const WorkingMesh* part(std::size_t level, Index number);

 private:
  const TriangleMaker& triangles_;
  const Mirrors mirrors_;
  std::size_t count_, second_;
  WorkingMesh first_;
  FaceData<Index> numbers_;
  std::vector<std::vector<WorkingMesh>> levels_;
};

}  // namespace remesher
