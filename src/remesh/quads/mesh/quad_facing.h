// SPDX-License-Identifier: MIT
// Tells quads that face away from the surface that they lie on: where it is thin, normals at their
// corners may be those of either side.
#pragma once

#include "geometry/mesh_tree.h"
#include "geometry/quad.h"
#include "remesh/operators/working_mesh.h"

namespace remesher {

class QuadFacing {
 public:
  // ground: any mesh on the original, which must outlive this.
  explicit QuadFacing(const WorkingMesh& ground);

  // Whether all of the original near the quad's middle faces the other way or stands upright, and
  // some of it does face the other way.
  bool isAway(const Quad& corners) const;

 private:
  const MeshTree tree_;
};

}  // namespace remesher
