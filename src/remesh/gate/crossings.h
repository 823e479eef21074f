// SPDX-License-Identifier: MIT
// Finds triangles of the mesh that pass through each other, however far apart along the surface:
// neither normals nor angles reveal them.
#pragma once

#include <vector>

#include "geometry/mesh_tree.h"
#include "remesh/operators/local_change.h"

namespace remesher {

class Crossings {
 public:
  // Records where the triangles are; `update` must be called for each that changes afterwards.
  explicit Crossings(const WorkingMesh& mesh);

  // Whether the change makes more pairs of triangles pass through each other than do now.
  bool grow(const LocalChange& change) const;

  void update(Face f);

  // The triangles looked at so far.
  std::size_t looked() const { return looked_; }

 private:
  // A triangle's vertices, to recognise neighbours, and their positions.
  struct Named {
    std::array<Vertex, 3> vertices;
    Triangle at;
  };

  static bool pass(const Named& s, const Named& t);
  Named present(Face f) const;
  std::size_t count(const std::vector<Named>& triangles, const LocalChange& change) const;

  const WorkingMesh& mesh_;
  const MeshTree tree_;
  double farthest_ = 0;  // distance of a corner from its position in the tree
  mutable std::size_t looked_ = 0;
};

}  // namespace remesher
