// SPDX-License-Identifier: MIT
// A tree of boxes over a halfedge mesh's triangles, as they are when the tree is built. Finds what
// is near in space, however far it is along the surface.
#pragma once

#include <vector>

#include "geometry/triangle_tree.h"
#include "mesh/halfedge_mesh.h"

namespace remesher {

class MeshTree {
 public:
  struct Nearest {
    Face face;
    double distance;
  };

  MeshTree(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions);
  MeshTree(const MeshTree&) = delete;  // the tree refers to the lists beside it
  MeshTree& operator=(const MeshTree&) = delete;

  // start: a face near p makes the search faster; may be none.
  Nearest nearest(const Vec3& p, Face start = {}) const;

  // The triangles alone, in the order of their faces.
  const TriangleTree& triangles() const { return tree_; }

  // Where the triangle was when the tree was built.
  Triangle corners(Face f) const { return tree_.corners(number_[f]); }

  // Calls visit(face) for each triangle whose box had a point in common with `box`.
  template <class Visit>
  void visitOverlapping(const Box& box, Visit&& visit) const {
    tree_.visitOverlapping(box, [&](Index number) { visit(faces_[number]); });
  }

 private:
  const std::vector<Vec3> positions_;
  const std::vector<Index> triangles_;
  std::vector<Face> faces_;  // by number in the list
  FaceData<Index> number_;   // per face its number
  const TriangleTree tree_;
};

}  // namespace remesher
