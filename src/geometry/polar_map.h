// SPDX-License-Identifier: MIT
// Geodesic polar maps [DGP 2016, "Geodesic Polar Mapping", Figure 4]: the neighbourhood of a vertex
// or of an edge laid out in the plane, where the local operators do their geometry.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "mesh/halfedge_mesh.h"

namespace remesher {

// The one-ring of an inner vertex: it keeps the lengths of the spokes and scales the angles between
// them so that they sum to 2π. The vertex itself is the origin. One object serves many vertices and
// keeps its buffers.
class PolarMap {
 public:
  void build(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions, Vertex v);

  Vertex center() const { return center_; }
  int size() const { return int(rim_.size()); }
  Vertex neighbor(int i) const { return neighbors_[i]; }
  const Vec2& rim(int i) const { return rim_[i]; }
  int after(int i) const { return i + 1 == size() ? 0 : i + 1; }
  double meanSpoke() const;

  // The triangle (v, neighbor(i), neighbor(i + 1)) that holds `p`, by i, with the weights of these
  // three corners; none when p lies outside the star.
  struct Location {
    int triangle;
    Vec3 barycentric;
  };
  std::optional<Location> locate(const Vec2& p) const;

 private:
  Vertex center_;
  std::vector<Vertex> neighbors_;
  std::vector<Vec3> spokes_;
  std::vector<Vec2> rim_;
};

// The two triangles of an inner edge a-b, unfolded into one plane: a at the origin, b on the
// positive x axis, c (opposite h) above and d (opposite its twin) below.
struct UnfoldedEdge {
  Vec2 a, b, c, d;
};
UnfoldedEdge unfold(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions, Halfedge h);

// Whether d lies outside the circle through a, b and c by more than rounding.
bool isLocallyDelaunay(const UnfoldedEdge& quad);

}  // namespace remesher
