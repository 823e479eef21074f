// SPDX-License-Identifier: MIT
// Keeps each face of the result, triangle or quad, within one chart of every attribute. Where seams
// are curves, this holds by construction. A face across a seam that was let go takes the chart of
// most of its corners, and its other corners take the nearest points of that chart: nothing bleeds.
// Charts too narrow for triangles of their own give way to those beside them, whose values and
// shading extend over them. Otherwise the triangles along them would show the two charts by turns,
// like the teeth of a saw.
#pragma once

#include <span>
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

  // points: where the corners of a face lie on the original. Moves them to where they take their
  // attributes.
  void intoOneChart(std::span<SurfacePoint> points);

 private:
  struct Ball {
    Vec3 center;
    double radius;
  };

  void collect(Face start, const Ball& ball);
  Face absorberOf(std::span<const SurfacePoint> points);
  Face chartFor(std::span<const SurfacePoint> points, const Ball& ball);
  bool contains(Face f) const { return seen_[f] == stamp_; }
  void intoChart(std::span<SurfacePoint> points) const;

  const WorkingMesh& mesh_;
  const ChartRules& rules_;
  HalfedgeData<char> jumps_;
  bool any_ = false;
  // What collect() found: the faces of one chart about a face of the result.
  std::vector<Face> chart_;
  FaceData<Index> seen_;
  Index stamp_ = 0;
};

}  // namespace remesher
