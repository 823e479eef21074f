// SPDX-License-Identifier: MIT
// A partition of a mesh's faces into compact, connected, nearly flat cells: the cores of patches.
#pragma once

#include <span>
#include <vector>

#include "mesh/halfedge_mesh.h"

namespace remesher {

// Centroid and unit normal (zero for a face without area) of every face. In float, because they
// only steer growth.
struct FaceFrame {
  Eigen::Vector3f centroid = Eigen::Vector3f::Zero();
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();
};
FaceData<FaceFrame> faceFrames(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions);

class FaceCells {
 public:
  std::size_t count() const { return firstFace_.size() - 1; }
  Index cellOf(Face f) const { return cell_[f]; }  // kNone if the face is dead
  // The cell's faces, in an order in which each face but the first has a neighbour before it.
  std::span<const Face> faces(Index cell) const {
    return std::span(faces_).subspan(firstFace_[cell], firstFace_[cell + 1] - firstFace_[cell]);
  }

 private:
  friend class CellGrowth;

  FaceData<Index> cell_;
  std::vector<Index> firstFace_ = {0};  // of each cell, in faces_; one more at the end
  std::vector<Face> faces_;
};

// Makes cells of about `size` faces. A cell's normals lie within a cone, and no cell crosses a
// barrier.
FaceCells partitionFaces(const HalfedgeMesh& mesh, const FaceData<FaceFrame>& frames,
                         std::span<const char> barriers, std::size_t size);

}  // namespace remesher
