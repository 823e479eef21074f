// SPDX-License-Identifier: MIT
// Projects a point of a current triangle [DGP 2016, "Projection on the Initial Surface"]: onto the
// original through the overlapping disk patches, or, for comparison, on the current mesh.
#pragma once

#include <optional>

#include "base/options.h"
#include "original/patches/patch_atlas.h"
#include "remesh/operators/working_mesh.h"

namespace remesher {

// A place this near, in units of an edge's length, is as good as the place itself.
inline constexpr double kPlainlyNear = 0.05;

class Projector {
 public:
  // reach: the longest edge that will be projected, model units; patches overlap accordingly.
  Projector(const OriginalSurface& surface, Projection mode, double reach);
  Projection mode() const { return mode_; }

  // Projects by walks over the surface alone, without patches, which take time to build.
  explicit Projector(const OriginalSurface& surface) : surface_(&surface) {}

  // Whether it projects by walks alone.
  bool walks() const { return !atlas_; }

  // From now on projects onto `surface`, by walks alone: for a mesh that is near it already.
  void moveOnto(const OriginalSurface& surface);

  // Projects the point of face(h) with these barycentric weights, the first one for origin(h).
  Placement project(const WorkingMesh& mesh, Halfedge h, const Vec3& weights);

 private:
  SurfacePoint onOriginal(const std::array<SurfacePoint, 3>& corners, const Triangle& places,
                          const Vec3& weights);

  const OriginalSurface* surface_;
  Projection mode_ = Projection::Patches;
  std::optional<PatchAtlas> atlas_;
};

}  // namespace remesher
