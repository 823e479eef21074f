// SPDX-License-Identifier: MIT
// The original surface covered by overlapping disk patches, each mapped to the unit disk [report,
// "Projection on the Initial Surface"]. A partition into small cells is made, and each cell is
// grown by a margin to a patch. A point with barycentric weights between three surface points is
// found by mixing their images in a patch that holds all three. Patches are built when first
// needed.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "geometry/surface_point.h"
#include "geometry/triangle.h"
#include "mesh/halfedge_mesh.h"

namespace remesher {

class PatchAtlas {
 public:
  // mesh and positions must outlive the atlas. margin: how far, in model units, a patch reaches
  // beyond its cell; about 1.5 × the longest edge of the meshes to be projected. Patches never
  // reach across a halfedge marked in `barriers` (sized to the mesh, both halfedges of an edge
  // marked), if given.
  PatchAtlas(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions, double margin,
             HalfedgeData<char> barriers = {});
  ~PatchAtlas();
  PatchAtlas(PatchAtlas&&) noexcept;

  // The point that lies in the plane of some patch at weights[0]·a + weights[1]·b + weights[2]·c,
  // or none when no patch holds all three corners or the map would throw it far off the triangle.
  std::optional<SurfacePoint> interpolate(const std::array<SurfacePoint, 3>& corners,
                                          const Vec3& weights);

  // The same with the corners' positions given. They may lie slightly off the original; the limits
  // on the distance are measured from them.
  std::optional<SurfacePoint> interpolate(const std::array<SurfacePoint, 3>& corners,
                                          const Triangle& places, const Vec3& weights);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace remesher
