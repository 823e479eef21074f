// SPDX-License-Identifier: MIT
// The nearest point of all of the original, for where a walk to it may end in a valley (see
// surface_walk.h). The tree is built when it is first asked.
#pragma once

#include <optional>

#include "geometry/triangle_tree.h"
#include "original/surface/original_surface.h"

namespace remesher {

class OriginalTree {
 public:
  struct Nearest {
    double distance;
    Index looked;  // at so many triangles
  };

  // input: what the surface was built of, if that is at hand. Both must outlive the tree.
  explicit OriginalTree(const OriginalSurface& surface, const TriangleMesh* input = nullptr)
      : surface_(surface), input_(input) {}

  // Faster where `start` is a face near p.
  Nearest nearest(const Vec3& p, Face start);

  // The tree over the input's positions, which is gone from here, for whoever measures the input:
  // if it was asked for, and the surface has all of the input's triangles that are no lines.
  std::optional<ListedTree> ofInput();

 private:
  void build();

  const OriginalSurface& surface_;
  const TriangleMesh* input_;
  std::optional<ListedTree> tree_;
};

}  // namespace remesher
