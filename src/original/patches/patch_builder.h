// SPDX-License-Identifier: MIT
// Makes the patches of an atlas: around a cell of the partition with a margin, or around three
// faces, as the report does for every query.
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

  // The patch holds the three faces, all faces within a few steps of the ways between them, and the
  // connected faces with centroids in the ball, up to a limit; or it is empty.
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
    int steps;    // number of faces between
  };
  std::vector<Reach> reaches_;  // per face of the grower
  struct Way {
    Face face;
    Index from;  // in ways_: the face before it
  };
  std::vector<Way> ways_;
  FaceData<Index> visited_;  // per face the last search that met it
  Index visit_ = 0;
  std::size_t visitedFaces_ = 0;
};

}  // namespace remesher
