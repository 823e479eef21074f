// SPDX-License-Identifier: MIT
// A seamless map in whole numbers: exact, so that walking over it never errs. A coordinate of 1 is
// kUnit.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "remesh/quads/map/rounding.h"
#include "remesh/quads/map/seamless_system.h"

namespace remesher {

using Whole = std::int64_t;
inline constexpr Whole kUnit = Whole{1} << 20;

struct MapPoint {
  Whole u = 0, v = 0;
  auto operator<=>(const MapPoint&) const = default;
};

inline MapPoint operator+(const MapPoint& a, const MapPoint& b) { return {a.u + b.u, a.v + b.v}; }
inline MapPoint operator-(const MapPoint& a, const MapPoint& b) { return {a.u - b.u, a.v - b.v}; }

// Twice the area of the triangle, positive where it is counterclockwise. Exact as long as the
// triangle is smaller than 512 in every direction.
inline Whole orientation(const MapPoint& a, const MapPoint& b, const MapPoint& c) {
  return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
}

// Where h is crossed: the pair turns so often by a quarter, and moves.
struct Transition {
  int turn = 0;
  MapPoint shift;
  MapPoint operator()(const MapPoint& p) const;
};

struct SeamlessMap {
  HalfedgeData<MapPoint> corners;  // per corner: the origin of h in face(h)
  HalfedgeData<int> turn;          // over h; see CutField

  Transition across(const HalfedgeMesh& mesh, Halfedge h) const;
  Whole area(Face f) const {
    const Halfedge h = HalfedgeMesh::halfedge(f);
    return orientation(corners[h], corners[HalfedgeMesh::next(h)], corners[HalfedgeMesh::prev(h)]);
  }
};

// Makes maps of one surface at any scale.
class MapMaker {
 public:
  // The mesh must outlive it.
  MapMaker(const WorkingMesh& mesh, const CrossField& field);

  // Whether there can be any map; false as well where there are more singular vertices than dense
  // matrices are for.
  bool isPossible() const { return bool(rounding_); }

  // With quads of this length. Triangles that fold over are unfolded as far as that goes.
  SeamlessMap map(double length) const;

  // How many vertices the quads of a map have, if they are a surface like that of the mesh.
  double countVertices(const SeamlessMap& map) const;

 private:
  SeamlessMap inWholes(const Eigen::VectorXd& values) const;

  const WorkingMesh& mesh_;
  FaceFrames frames_;
  VertexData<int> singular_;
  CutField cut_;
  SeamlessSystem system_;
  std::unique_ptr<Rounding> rounding_;
};

}  // namespace remesher
