// SPDX-License-Identifier: MIT
// The original surface: built once, then const. Positions and normals of every SurfacePoint are
// read from it.
#pragma once

#include <vector>

#include "geometry/surface_point.h"
#include "mesh/mesh_builder.h"
#include "original/curves/feature_curves.h"
#include "original/curves/flat_regions.h"

namespace remesher {

class OriginalSurface {
 public:
  // flats: the regions that are to stay flat, if any.
  OriginalSurface(BuiltMesh built, FeatureCurves curves, FlatRegions flats = {});

  const HalfedgeMesh& mesh() const { return built_.mesh; }
  const VertexData<Vec3>& positions() const { return built_.positions; }
  const BuiltMesh& built() const { return built_; }
  const FeatureCurves& curves() const { return curves_; }
  bool hasFlats() const { return !flats_.empty(); }
  bool isFlat(Face f) const { return flats_.at(f) != kNone; }
  // Whether p lies in a plane, which vertices at p may not leave.
  bool isFlatAt(const SurfacePoint& p) const { return isFlat(p.face); }
  // Both halfedges of every curve edge; projection must not cross these.
  const HalfedgeData<char>& barriers() const { return barriers_; }
  double diagonal() const { return diagonal_; }  // of the bounding box
  double area() const { return area_; }

  Vec3 position(const SurfacePoint& p) const;
  // The corners' normals mixed by the weights of p; each is area-weighted over the faces on its
  // side of the curves [DGP 2016, "Controlling Mesh Fidelity"]. Not renormalised.
  Vec3 normal(const SurfacePoint& p) const;
  const Vec3& cornerNormal(Halfedge h) const { return normals_[normalOf_[h]]; }

  SurfacePoint at(Vertex v) const;  // v as a corner of one of its faces

 private:
  void computeNormals();

  BuiltMesh built_;
  FeatureCurves curves_;
  FlatRegions flats_;
  HalfedgeData<char> barriers_;
  HalfedgeData<Index> normalOf_;  // per corner: its side's normal
  std::vector<Vec3> normals_;
  double diagonal_ = 0;
  double area_ = 0;
};

}  // namespace remesher
