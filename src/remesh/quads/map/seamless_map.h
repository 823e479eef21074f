// SPDX-License-Identifier: MIT
// A seamless map in integers: exact, so that a walk over the map never errs. A coordinate of 1 is
// stored as kUnit.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "remesh/quads/map/rounding.h"
#include "remesh/quads/map/seamless_system.h"

namespace remesher {

using Fixed = std::int64_t;  // in units of 1/kUnit
inline constexpr Fixed kUnit = Fixed{1} << 20;
// Products of two such lengths, and sums of a few of them, fit into a whole number.
inline constexpr Fixed kLongest = Fixed{1} << 29;

struct MapPoint {
  Fixed u = 0, v = 0;
  auto operator<=>(const MapPoint&) const = default;
};

inline MapPoint operator+(const MapPoint& a, const MapPoint& b) { return {a.u + b.u, a.v + b.v}; }
inline MapPoint operator-(const MapPoint& a, const MapPoint& b) { return {a.u - b.u, a.v - b.v}; }

// Twice the area of the triangle, positive where it is counterclockwise. Exact as long as the
// triangle is smaller than kLongest in every direction.
inline Fixed orientation(const MapPoint& a, const MapPoint& b, const MapPoint& c) {
  return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
}

// The change of coordinates across h: `turn` quarter turns, then a shift.
struct Transition {
  int turn = 0;
  MapPoint shift;
  MapPoint operator()(const MapPoint& p) const;
};

// Both, one after the other.
Transition after(const Transition& first, const Transition& second);

struct SeamlessMap {
  HalfedgeData<MapPoint> corners;  // per corner: the origin of h in face(h)
  HalfedgeData<int> turn;          // over h; see CutField
  Eigen::VectorXd integers;        // the integer variables
  double length = 0;               // of the quads
  double mark = 0;  // of the rounded values: maps of one surface differ if these differ

  Transition across(const HalfedgeMesh& mesh, Halfedge h) const;
  Fixed area(Face f) const {
    const Halfedge h = HalfedgeMesh::halfedge(f);
    return orientation(corners[h], corners[HalfedgeMesh::next(h)], corners[HalfedgeMesh::prev(h)]);
  }
};

// Makes maps of one surface at any scale.
class MapMaker {
 public:
  // sizes: per face the side length of quads wanted there beside the others. The mesh must outlive
  // it.
  MapMaker(const WorkingMesh& mesh, const CrossField& field, FaceData<double> sizes);

  // Takes other sizes: all else stays as it is.
  void setSizes(FaceData<double> sizes);

  // Whether a map is possible; also false with too many integer variables for dense matrices.
  bool isPossible() const { return bool(rounding_); }

  // A map with quads of this length, unless its mark is known or it is too large to be exact.
  // Folded triangles are unfolded as far as possible.
  std::optional<SeamlessMap> map(double length, std::span<const double> known = {}) const;

  // The same with integer variables of its own.
  std::optional<SeamlessMap> mapOf(const Eigen::VectorXd& integers, double length) const;

  // The integer variables of maps like this one whose loops of quads are shorter, the best first.
  // vertices: of the quads, within the share `slack`.
  std::vector<Eigen::VectorXd> withShorterLoops(const SeamlessMap& map, double vertices,
                                                double slack) const;

  // Whether all maps together took so much work that no more should be made.
  bool isSpent() const;

  // The number of vertices that must be at places of their own: a smaller number has no map.
  std::size_t singularCount() const;

  // The number of vertices of a map's quads, if these are a surface of the mesh's kind.
  double countVertices(const SeamlessMap& map) const;

 private:
  std::optional<SeamlessMap> unfolded(Eigen::VectorXd values, double length) const;
  SeamlessMap inIntegers(const Eigen::VectorXd& values) const;

  const WorkingMesh& mesh_;
  FaceFrames frames_;
  FaceData<double> sizes_;
  VertexData<int> singular_;
  CutField cut_;
  SeamlessSystem system_;
  std::unique_ptr<Rounding> rounding_;
};

}  // namespace remesher
