// SPDX-License-Identifier: MIT
// Finds quads that face away from the surface they lie on. Where it is thin, normals at their
// corners may be those of either side: all triangles near a quad's middle are looked at.
#pragma once

#include "geometry/quad.h"
#include "geometry/triangle_tree.h"

namespace remesher {

class QuadFacing {
 public:
  // surface: the triangles of the original; must outlive this.
  explicit QuadFacing(const TriangleTree& surface) : tree_(surface) {}

  // Whether all of the surface near the quad's middle faces the other way or stands upright, and
  // some of it does face the other way. True without an area.
  bool isAway(const Quad& corners) const;

 private:
  const TriangleTree& tree_;
};

}  // namespace remesher
