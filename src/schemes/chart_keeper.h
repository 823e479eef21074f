// SPDX-License-Identifier: MIT
// Keeps each triangle of the result within one chart of every attribute. Where a seam is a curve it
// is by construction; a triangle across a seam that was let go takes the chart that most of its
// corners are in, and its other corners the nearest points of it: nothing bleeds.
#pragma once

#include <array>
#include <vector>

#include "operators/working_mesh.h"

namespace remesher {

class ChartKeeper {
 public:
  // jumps: the edges of the original across which an attribute jumps, one halfedge of each.
  ChartKeeper(const WorkingMesh& mesh, const std::vector<Halfedge>& jumps);

  // Where on the original the three corners of a triangle take their attributes.
  std::array<SurfacePoint, 3> corners(Face f);

 private:
  struct Ball {
    Vec3 center;
    double radius;
  };

  void collect(Face start, const Ball& ball);
  bool contains(Face f) const { return seen_[f] == stamp_; }
  std::array<SurfacePoint, 3> intoChart(const std::array<SurfacePoint, 3>& points) const;

  const WorkingMesh& mesh_;
  HalfedgeData<char> jumps_;
  bool any_ = false;
  // What collect() found: the faces of one chart about a triangle.
  std::vector<Face> chart_;
  FaceData<Index> seen_;
  Index stamp_ = 0;
};

}  // namespace remesher
