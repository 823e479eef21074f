// SPDX-License-Identifier: MIT
// From a place of the original to the part of the mesh that stands for it. Nearest in space is not
// it where the original lies in folds: the mesh may pass by on the other side of a thin wall.
#pragma once

#include <vector>

#include "remesh/operators/working_mesh.h"

namespace remesher {

class PlaceFinder {
 public:
  // A snapshot: vertices that are made or moved later are not found, those that vanish must not be.
  explicit PlaceFinder(const WorkingMesh& mesh);

  // A few vertices of the mesh around a place, found by going over the original from there.
  std::vector<Vertex> verticesNear(const SurfacePoint& place) const;

 private:
  const WorkingMesh& mesh_;
  std::vector<Index> begins_;  // per face of the original, and one more
  std::vector<Vertex> vertices_;
};

}  // namespace remesher
