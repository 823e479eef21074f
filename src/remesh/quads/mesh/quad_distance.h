// SPDX-License-Identifier: MIT
// Tells maps that follow a surface from those that leave it.
#pragma once

#include <vector>

#include "geometry/triangle_tree.h"
#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

class QuadDistance {
 public:
  // The mesh must outlive it.
  explicit QuadDistance(const WorkingMesh& mesh);

  // The largest distance of the mesh's vertices from the quads, and of the middles of some quads
  // from the mesh, in sides of quads; 0 if all are nearer than a side.
  double sidesAway(const QuadMesh& quads) const;

 private:
  const WorkingMesh& mesh_;
  const std::vector<Index> corners_;
  const TriangleTree tree_;
};

}  // namespace remesher
