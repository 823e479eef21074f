// SPDX-License-Identifier: MIT
#include "geometry/mesh_tree.h"

#include <cmath>

namespace remesher {

MeshTree::MeshTree(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions)
    : positions_(positions.values()),
      triangles_(mesh.triangles()),
      number_(mesh.faceCapacity(), kNone),
      tree_(positions_, triangles_) {
  for (Index i = 0; i < mesh.faceCapacity(); ++i) {
    if (!mesh.isAlive(Face(i))) continue;
    number_[Face(i)] = Index(faces_.size());
    faces_.push_back(Face(i));
  }
}

MeshTree::Nearest MeshTree::nearest(const Vec3& p, Face start) const {
  const TriangleTree::Nearest nearest = tree_.nearest(p, start ? number_[start] : kNone);
  return {faces_[nearest.triangle], std::sqrt(nearest.squaredDistance)};
}

}  // namespace remesher
