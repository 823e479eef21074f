// SPDX-License-Identifier: MIT
// Triangles of the mesh that pass through each other, however far apart along the surface they are:
// what neither normals nor angles can see.
#pragma once

#include <vector>

#include "geometry/mesh_tree.h"
#include "remesh/operators/local_change.h"

namespace remesher {

class Crossings {
 public:
  // Remembers where the triangles are; what changes afterwards is to be told to `update`.
  explicit Crossings(const WorkingMesh& mesh);

  // Whether the change makes more pairs of triangles pass through each other than do now.
  bool grow(const LocalChange& change) const;

  void update(Face f);

  // The triangles looked at so far.
  std::size_t looked() const { return looked_; }

 private:
  // Corners by name, so that neighbours are known, and by place.
  struct Named {
    std::array<Vertex, 3> vertices;
    Triangle at;
  };

  static bool pass(const Named& s, const Named& t);
  Named present(Face f) const;
  std::size_t count(const std::vector<Named>& triangles, const LocalChange& change) const;

  const WorkingMesh& mesh_;
  const MeshTree tree_;
  double farthest_ = 0;  // that a corner is now from where the tree has it
  mutable std::size_t looked_ = 0;
};

}  // namespace remesher
