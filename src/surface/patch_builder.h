// SPDX-License-Identifier: MIT
// Makes the patches of an atlas: around a cell of the partition with a margin, or, as the report
// does for every query, around three faces.
#pragma once

#include <array>

#include "surface/disk_parameterization.h"
#include "surface/disk_patch.h"
#include "surface/face_cells.h"
#include "surface/point_location.h"

namespace remesher {

class PatchBuilder {
 public:
  // mesh, positions and barriers must outlive the builder. margin: how far, in model units, patches
  // reach beyond their cells.
  PatchBuilder(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
               std::span<const char> barriers, double margin);

  const FaceCells& cells() const { return cells_; }

  // Both are empty if no one-to-one map was found. A patch around three faces holds them all, or is
  // empty; it reaches beyond `centre` by `reach`, model units.
  PlanarPatch aroundCell(Index cell);
  PlanarPatch aroundFaces(const std::array<Face, 3>& faces, const Vec3& centre, double reach);

  // The work done so far for aroundFaces, in faces visited.
  std::size_t visitedFaces() const { return visitedFaces_; }

 private:
  void growCore(Index cell);
  void growMargin();
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
  std::size_t visitedFaces_ = 0;
};

}  // namespace remesher
