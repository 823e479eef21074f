// SPDX-License-Identifier: MIT
// The nearest point on the whole original, for places where a walk may end in a local minimum (see
// surface_walk.h). The tree is built at the first query.
#pragma once

#include <optional>

#include "geometry/triangle_tree.h"
#include "original/surface/original_surface.h"

namespace remesher {

class OriginalTree {
 public:
  struct Nearest {
    double distance;
    Index looked;  // number of triangles looked at
  };

  // input: the mesh the surface was built from, if at hand. Both must outlive the tree.
  explicit OriginalTree(const OriginalSurface& surface, const TriangleMesh* input = nullptr)
      : surface_(surface), input_(input) {}

  // Faster when `start` is a face near p.
  Nearest nearest(const Vec3& p, Face start);

  // Hands over the tree over the input's positions, for measuring the input. Empty if the tree was
  // never built, or if the surface lacks triangles of the input other than `lines`.
  std::optional<ListedTree> ofInput();

 private:
  void build();

  const OriginalSurface& surface_;
  const TriangleMesh* input_;
  std::optional<ListedTree> tree_;
};

}  // namespace remesher
