// SPDX-License-Identifier: MIT
// Divides the triangles of a mesh along lines on it, so that the lines become edges. The surface
// stays what it is.
#pragma once

#include <array>
#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "base/input_place.h"
#include "base/options.h"
#include "base/triangle_mesh.h"
#include "geometry/triangle_tree.h"

namespace remesher {

class Imprint {
 public:
  // edges: of the input, by its vertices; they are divided with their triangles. near: a point so
  // near to a vertex or an edge may become that.
  Imprint(const TriangleMesh& input, std::span<const std::pair<Index, Index>> edges, double near);

  // Makes edges of a guide whose points lie on the input. What it follows now, which differs from
  // the guide within a triangle only; or no points if the surface does not join its points.
  Guide add(const Guide& guide);

  // The divided mesh without attributes; its first vertices are the input's.
  const TriangleMesh& mesh() const { return mesh_; }
  // The edges of the guides, and the input's given ones, by the mesh's vertices.
  std::vector<std::pair<Index, Index>> edges() const { return {edges_.begin(), edges_.end()}; }
  // Of a vertex after the input's, where it is on the input.
  const InputPlace& placeOf(Index newVertex) const { return places_[newVertex - given_]; }
  // A place on the divided mesh, on the input.
  InputPlace onInput(const InputPlace& place) const;

 private:
  using Corners = std::array<Index, 3>;
  using Weights = std::array<Vec3, 3>;

  Corners corners(Index t) const;  // by the first vertex of each place
  const Vec3& at(Index v) const { return mesh_.positions[v]; }
  Weights weightsOf(Index t) const;
  bool areJoined(Index v, Index w) const;
  bool isBoundary(Index v, Index w) const;
  Vec3 normalNear(Index v) const;

  Index addVertex(const Vec3& p, const InputPlace& place);
  Index addTriangle(Index like, const Corners& wedges, const Weights& weights);
  void setTriangle(Index t, const Corners& wedges, const Weights& weights);
  Index splitEdge(Index a, Index b, double t);
  Index splitFace(Index t, const Vec3& weights);
  Index vertexAt(const Vec3& p);
  Index endAt(const Vec3& p);
  Index snapped(Index t, const Vec3& p);

  struct Plane {
    Vec3 normal, target;
  };
  struct Crossing {
    Index a = kNone, b = kNone;
    double t = 0;  // from a to b
    double left = kInfinity;
  };
  Crossing crossingFrom(Index v, const Plane& plane) const;
  bool walk(Index from, Index to, std::vector<Index>& path);
  bool follow(Index from, Index to, std::vector<Index>& path) const;
  void mark(Index v, Index w) { edges_.insert(std::minmax(v, w)); }

  TriangleMesh mesh_;
  const Index given_;  // vertices of the input
  const double near_;
  std::vector<Index> first_;                      // per vertex the first at its place
  std::vector<Index> parents_;                    // per triangle the input's
  std::map<Index, Weights> weights_;              // of divided triangles: their corners there
  std::map<Index, std::vector<Index>> children_;  // of divided triangles of the input
  std::vector<std::vector<Index>> around_;        // per first vertex its triangles
  std::vector<InputPlace> places_;
  std::set<std::pair<Index, Index>> edges_;
  const TriangleTree tree_;
};

}  // namespace remesher
