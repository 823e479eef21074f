// SPDX-License-Identifier: MIT
// A triangulation of points in one plane in which given segments are edges. Segments that cross are
// split there, at an exact point. It starts from a triangle of far points, so that every point
// inserted is interior.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <unordered_map>
#include <vector>

#include "arrangement/points.h"

namespace remesher {

// Through which line a segment runs: that of two given points, or (with a third one) the plane of
// three given points meets the plane of the sheet there.
struct Support {
  std::array<Index, 3> points = {kNone, kNone, kNone};

  bool isPlane() const { return points[2] != kNone; }
  bool operator==(const Support&) const = default;
};

struct Segment {
  Index from, to;  // points
  Support support;
};

class SheetTriangulation {
 public:
  // plane: three given points of it.
  SheetTriangulation(PointPool& points, const GivenPlane& plane);

  // Points must lie in the plane. A point may come more than once.
  void insert(Index point);
  // The ends must have been inserted.
  void force(const Segment& segment);
  // Flips edges that are no segments where that widens the smallest angle, as seen along the normal
  // of the plane; not at far points.
  void widenAngles();

  std::size_t triangleCount() const { return corners_.size() / 3; }
  // The points of a triangle, counterclockwise in view().
  std::array<Index, 3> triangle(Index t) const;
  // The triangle across the edge from corner k to the next one; kNone outside.
  Index neighbor(Index t, Index k) const;
  bool isSegment(Index t, Index k) const { return supports_[3 * t + k] != kNone; }
  // A triangle with this corner.
  Index triangleAt(Index point) const { return outgoing_[numbers_.at(point)] / 3; }

  FlatView view() const { return view_; }
  // Steps of work: triangles walked through, flips, new points.
  std::size_t work() const { return work_; }

 private:
  // A place in points_. Halfedges are numbered as in mesh/edge_groups.h.
  using Vertex = Index;

  Vertex tail(Index h) const { return corners_[h]; }
  Vertex head(Index h) const;
  Vertex apex(Index h) const;
  int turn(Vertex a, Vertex b, Vertex c) const {
    return pool_.turn(points_[a], points_[b], points_[c], view_);
  }
  Index locate(Index point, std::size_t& zeros, Index& onEdge);
  Vertex addVertex(Index point);
  void setTriangle(Index t, const std::array<Vertex, 3>& corners);
  void link(Index h, Index twin, Index support);
  void splitTriangle(Index t, Vertex v);
  void splitEdge(Index h, Vertex v);
  // Flips the edges where that widens angles, then those beside flipped ones: of these only the
  // ones opposite to a new vertex, or all for kNone.
  void legalize(std::vector<Index> edges, Vertex around);
  bool isConvex(Index h) const;
  void flip(Index h);
  bool wantsFlip(Index h) const;
  // Rounding could turn edges between nearly coincident points round and round.
  std::size_t mostFlips() const { return 64 + 16 * triangleCount(); }
  Vec2 flat(Vertex v) const;
  Index findEdge(Vertex a, Vertex b) const;
  Vertex forceFrom(Vertex a, Vertex b, Index support);
  Vertex crossed(Index h, Index support);
  void clearWay(Vertex a, Vertex b, std::vector<std::array<Vertex, 2>> crossed);

  PointPool& pool_;
  GivenPlane plane_;
  FlatView view_;
  std::vector<Index> points_;                  // per vertex
  std::unordered_map<Index, Vertex> numbers_;  // of points
  std::vector<Vertex> corners_;                // three per triangle
  std::vector<Index> twins_, supports_;        // per halfedge
  std::vector<Index> outgoing_;                // per vertex a halfedge from it
  std::vector<Support> known_;                 // supports by number
  std::map<std::array<Index, 3>, Index> supportNumbers_;
  Eigen::Matrix2d shape_ = Eigen::Matrix2d::Identity();  // from the view to lengths in the plane
  Index last_ = 0;                                       // the triangle found last
  std::size_t work_ = 0;
};

}  // namespace remesher
