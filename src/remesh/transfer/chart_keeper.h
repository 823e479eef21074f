// SPDX-License-Identifier: MIT
// Keeps each triangle of the result within one chart of every attribute. Where seams are curves,
// this holds by construction. A triangle across a seam that was let go takes the chart of most of
// its corners, and its other corners take the nearest points of that chart: nothing bleeds. Charts
// too narrow for triangles of their own give way to those beside them, whose values and shading
// extend over them. Otherwise the triangles along them would show the two charts by turns, like the
// teeth of a saw.
#pragma once

#include <array>
#include <vector>

#include "remesh/operators/working_mesh.h"

namespace remesher {

struct ChartRules {
  // The edges of the original across which an attribute jumps, one halfedge of each.
  std::vector<Halfedge> jumps;
  // The faces whose charts give way, see SimplifiedCurves.
  FaceData<char> absorbed;
};

class ChartKeeper {
 public:
  // Both arguments must outlive the object.
  ChartKeeper(const WorkingMesh& mesh, const ChartRules& rules);

  // Where on the original the three corners of a triangle take their attributes.
  std::array<SurfacePoint, 3> corners(Face f);

 private:
  struct Ball {
    Vec3 center;
    double radius;
  };

  void collect(Face start, const Ball& ball);
  Face absorberOf(const std::array<SurfacePoint, 3>& points);
  Face chartFor(const std::array<SurfacePoint, 3>& points, const Ball& ball);
  bool contains(Face f) const { return seen_[f] == stamp_; }
  std::array<SurfacePoint, 3> intoChart(const std::array<SurfacePoint, 3>& points) const;

  const WorkingMesh& mesh_;
  const ChartRules& rules_;
  HalfedgeData<char> jumps_;
  bool any_ = false;
  // What collect() found: the faces of one chart about a triangle.
  std::vector<Face> chart_;
  FaceData<Index> seen_;
  Index stamp_ = 0;
};

}  // namespace remesher
