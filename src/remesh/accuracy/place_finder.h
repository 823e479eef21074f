// SPDX-License-Identifier: MIT
// Finds the part of the mesh that stands for a place of the original. Where the original lies in
// folds, the part nearest in space may be a wrong one, on the other side of a thin wall.
#pragma once

#include <vector>

#include "remesh/operators/working_mesh.h"

namespace remesher {

class PlaceFinder {
 public:
  // A snapshot: vertices that are made later are not found, moved ones only where they were. None
  // may vanish while it is in use.
  explicit PlaceFinder(const WorkingMesh& mesh);

  // A few vertices of the mesh around a place, found by going over the original from there.
  std::vector<Vertex> verticesNear(const SurfacePoint& place);

 private:
  const WorkingMesh& mesh_;
  std::vector<Index> begins_;  // per face of the original, and one more
  std::vector<Vertex> vertices_;
  FaceData<char> isSeen_;  // none between searches
};

}  // namespace remesher
