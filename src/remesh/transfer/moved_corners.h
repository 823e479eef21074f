// SPDX-License-Identifier: MIT
// The attributes of simplified vertices that left the place of their original: those of the
// original where they are now, on their own side of every seam.
#pragma once

#include <vector>

#include "base/triangle_mesh.h"
#include "geometry/surface_point.h"
#include "mesh/attribute_mix.h"
#include "mesh/mesh_builder.h"

namespace remesher {

class MovedCorners {
 public:
  // seams: the edges of the original across which an attribute jumps, both halfedges. The original
  // and the input must outlive the object.
  MovedCorners(const BuiltMesh& original, const TriangleMesh& input, HalfedgeData<char> seams);

  // Where a corner of the original is whose vertex is at `p` now: the nearest point of its chart.
  SurfacePoint pointNear(Halfedge corner, const Vec3& p);

  // Appends the attributes at a point, one list per attribute of the input and in its order.
  void append(const SurfacePoint& point, std::vector<Attribute>& values) const;

 private:
  const BuiltMesh& original_;
  const HalfedgeData<char> seams_;
  const AttributeMix mix_;
  // What pointNear() met: faces of one chart.
  std::vector<Face> chart_;
  FaceData<Index> seen_;
  Index stamp_ = 0;
};

}  // namespace remesher
