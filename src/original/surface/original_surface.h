// SPDX-License-Identifier: MIT
// The original surface: built once, then const. Everything that is carried as a SurfacePoint is
// read off here.
#pragma once

#include <vector>

#include "geometry/surface_point.h"
#include "mesh/mesh_builder.h"
#include "original/curves/feature_curves.h"

namespace remesher {

class OriginalSurface {
 public:
  OriginalSurface(BuiltMesh built, FeatureCurves curves);

  const HalfedgeMesh& mesh() const { return built_.mesh; }
  const VertexData<Vec3>& positions() const { return built_.positions; }
  const BuiltMesh& built() const { return built_; }
  const FeatureCurves& curves() const { return curves_; }
  // Both halfedges of every curve edge: what projection must not cross.
  const HalfedgeData<char>& barriers() const { return barriers_; }
  double diagonal() const { return diagonal_; }  // of the bounding box
  double area() const { return area_; }

  Vec3 position(const SurfacePoint& p) const;
  // The mix of the corners' normals, each area-weighted over the faces on its side of the curves
  // [report, "Controlling Mesh Fidelity"]; not renormalised.
  Vec3 normal(const SurfacePoint& p) const;
  const Vec3& cornerNormal(Halfedge h) const { return normals_[normalOf_[h]]; }

  SurfacePoint at(Vertex v) const;  // v as a corner of one of its faces

 private:
  void computeNormals();

  BuiltMesh built_;
  FeatureCurves curves_;
  HalfedgeData<char> barriers_;
  HalfedgeData<Index> normalOf_;  // per corner: its side's normal
  std::vector<Vec3> normals_;
  double diagonal_ = 0;
  double area_ = 0;
};

}  // namespace remesher
