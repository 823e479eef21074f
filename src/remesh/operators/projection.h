// SPDX-License-Identifier: MIT
// From a place on a current triangle to a placement [report, "Projection on the Initial Surface"]:
// onto the original through the overlapping disk patches, or, for comparison, on the current mesh.
#pragma once

#include <optional>

#include "base/options.h"
#include "original/patches/patch_atlas.h"
#include "remesh/operators/working_mesh.h"

namespace remesher {

class Projector {
 public:
  // reach: the longest edge that will be projected, model units; patches overlap accordingly.
  Projector(const OriginalSurface& surface, Projection mode, double reach);
  Projection mode() const { return mode_; }

  // By the shortest way alone: patches take time to build.
  explicit Projector(const OriginalSurface& surface) : surface_(&surface) {}

  // Whether it goes by the shortest way alone.
  bool walks() const { return !atlas_; }

  // Onto another surface from now on, by the shortest way: for what is near it already.
  void moveOnto(const OriginalSurface& surface);

  // The point with the given weights between the corners of the face of h, first that at origin(h).
  Placement project(const WorkingMesh& mesh, Halfedge h, const Vec3& weights);

 private:
  SurfacePoint onOriginal(const std::array<SurfacePoint, 3>& corners, const Triangle& places,
                          const Vec3& weights);

  const OriginalSurface* surface_;
  Projection mode_ = Projection::Patches;
  std::optional<PatchAtlas> atlas_;
};

}  // namespace remesher
