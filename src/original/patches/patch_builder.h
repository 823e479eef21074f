// SPDX-License-Identifier: MIT
// Makes the patches of an atlas: around a cell of the partition with a margin, or, as the report
// does for every query, around three faces.
#pragma once

#include <array>

#include "original/patches/disk_parameterization.h"
#include "original/patches/disk_patch.h"
#include "original/patches/face_cells.h"
#include "original/patches/point_location.h"

namespace remesher {

class PatchBuilder {
 public:
  // mesh, positions and barriers must outlive the builder. margin: how far, in model units, patches
  // reach beyond their cells.
  PatchBuilder(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
               std::span<const char> barriers, double margin);

  const FaceCells& cells() const { return cells_; }

  // Empty if no one-to-one map was found.
  PlanarPatch aroundCell(Index cell);

  // Holds the three faces and what lies within the ball around them, or is empty.
  struct Ball {
    Eigen::Vector3f centre;
    float radius;
    bool holds(const Eigen::Vector3f& p) const {
      return (p - centre).squaredNorm() <= radius * radius;
    }
  };
  PlanarPatch aroundFaces(const std::array<Face, 3>& faces, const Ball& ball);

  // The work done so far for aroundFaces, in faces visited.
  std::size_t visitedFaces() const { return visitedFaces_; }

 private:
  void growCore(Index cell);
  template <class IsWanted>
  void growOutwards(IsWanted isWanted);
  void growMargin();
  bool growWays(const std::array<Face, 3>& faces, const Ball& ball);
  bool addWay(Face f);
  PlanarPatch finish(std::span<const Face> kept);

  const VertexData<Vec3>& positions_;
  const float margin_;
  const FaceData<FaceFrame> frames_;
  const FaceCells cells_;
  DiskGrower grower_;
  DiskParameterizer parameterizer_;
  struct Reach {
    Face source;  // the cell's face that growth came from
    int steps;    // faces between
  };
  std::vector<Reach> reaches_;  // of the grower's faces
  struct Way {
    Face face;
    Index from;  // in ways_: the face before it
  };
  std::vector<Way> ways_;
  FaceData<Index> visited_;  // the last search that met the face
  Index visit_ = 0;
  std::size_t visitedFaces_ = 0;
};

}  // namespace remesher
