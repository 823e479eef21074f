// SPDX-License-Identifier: MIT
// The mesh being remeshed: connectivity, and for every vertex its place on the original surface
// [report, "Projection on the Initial Surface"]. Vertices know what they stand for (VertexKind),
// edges whether they run along a feature curve. Only the commands at the end change it; what is
// allowed is decided before, by the operators (legality) and the fidelity gate (geometry).
#pragma once

#include <limits>
#include <span>

#include "geometry/triangle.h"
#include "mesh/euler_operators.h"
#include "original/surface/original_surface.h"

namespace remesher {

// Interior: moves on the surface. Curve: moves along its feature curve. Corner: never moves.
enum class VertexKind : char { Interior, Curve, Corner };

// Where a vertex is. `at` is its point of the original; a vertex on a curve has one on each side
// and uses `on` instead (see WorkingMesh::cornerPoint); a corner's `at` names the original vertex.
struct Placement {
  Vec3 position = Vec3::Zero();
  Vec3 normal = Vec3::Zero();  // the original's there, unit; of a vertex on a curve: of some side
  SurfacePoint at;
  CurvePoint on;
  VertexKind kind = VertexKind::Interior;
  Vec3 across = Vec3::Zero();  // of a vertex on a curve: the normal on its other side, if any
};

class WorkingMesh {
 public:
  // A copy of the original: every vertex at its own place. `surface` must outlive the mesh.
  explicit WorkingMesh(const OriginalSurface& surface);

  // Other triangles on the original: compact, three corners each; per halfedge the one across and
  // the chain that the edge follows, or kNone; per vertex its place.
  struct Parts {
    std::vector<Index> triangles, twins, curves;
    std::vector<Placement> places;
  };
  WorkingMesh(const OriginalSurface& surface, const Parts& parts);

  const OriginalSurface& surface() const { return *surface_; }
  const HalfedgeMesh& mesh() const { return mesh_; }
  const VertexData<Vec3>& positions() const { return position_; }
  const Vec3& position(Vertex v) const { return position_[v]; }
  const Vec3& normal(Vertex v) const { return normal_[v]; }
  const Vec3& normalAcross(Vertex v) const { return across_[v]; }
  Triangle corners(Face f) const {
    const auto [a, b, c] = mesh_.vertices(f);
    return {position_[a], position_[b], position_[c]};
  }
  // Of the star of v: the sum of its triangles' area vectors, and the mean length of its spokes.
  Vec3 areaVectorAround(Vertex v) const;
  double meanSpoke(Vertex v) const;
  VertexKind kind(Vertex v) const { return kind_[v]; }
  const SurfacePoint& at(Vertex v) const { return at_[v]; }
  const CurvePoint& on(Vertex v) const { return on_[v]; }
  Placement placement(Vertex v) const;
  bool isPinned(Vertex v) const { return pinned_[v]; }  // smoothing leaves it alone

  // How far v's neighbours have gone, summed up, since v was last settled: endless where its star
  // has changed. Moves do not count by themselves: who moves says so where it matters.
  double unrest(Vertex v) const { return unrest_[v]; }

  // The chain that the edge of h follows, or kNone.
  Index curve(Halfedge h) const { return curve_[h]; }
  bool isCurve(Halfedge h) const { return curve_[h] != kNone; }
  // Whether the edge of h is to stay as it is.
  bool isKept(Halfedge h) const {
    return isCurve(h) && surface_->curves().chains()[curve_[h]].kept;
  }

  // The vertex of the original at or next to which a point lies: for a corner, which it is.
  Vertex originalCorner(const SurfacePoint& at) const;

  // The place of v on `chain`, on which it lies or of which it is an end.
  CurvePoint onChain(Vertex v, Index chain) const;

  // The original's point under the corner of face(h) at origin(h): for a vertex on a curve that on
  // the corner's own side, found by turning clockwise around the vertex to the nearest curve edge.
  SurfacePoint cornerPoint(Halfedge h) const;

  // A place of the surface, or of a curve, in full.
  Placement onSurface(const SurfacePoint& point) const;
  Placement onCurve(const CurvePoint& point) const;

  // The original's unit normal under a corner of a triangle whose normal is `n`: for a vertex on a
  // curve that of the side which the triangle faces.
  Vec3 normalFacing(Vertex v, const Vec3& n) const;
  Vec3 normalFacing(const Placement& place, const Vec3& n) const;

  Halfedge flip(Halfedge h);                                         // returns the new edge
  EulerOperators::Split split(Halfedge h, const Placement& middle);  // the new vertex at `middle`
  Vertex collapse(Halfedge h, const Placement& merged);              // tip(h) remains, at `merged`
  void move(Vertex v, const Placement& place);
  void pin(Vertex v) { pinned_[v] = 1; }
  void settle(Vertex v) { unrest_[v] = 0; }
  void stirNeighbors(Vertex v, double moved);  // v has gone so far
  void unsettleStar(Vertex v);                 // v and its neighbours
  void unsettleAll() { unrest_.assign(unrest_.size(), kEndless); }
  void settleAll() { unrest_.assign(unrest_.size(), 0); }

  // Each triangle becomes four. midpoints[i] is the place of the middle of the i-th edge, in the
  // order of the edges' halfedges. The mesh must be compact.
  void subdivide(std::span<const Placement> midpoints);

  // The same mesh on another surface that has the same curves. `points`, one for each vertex, say
  // where; what is on curves stays where it is on them.
  void moveOnto(const OriginalSurface& surface, const VertexData<SurfacePoint>& points);

  // Closes the holes that deletions left.
  void compact();

 private:
  static constexpr double kEndless = std::numeric_limits<double>::infinity();

  void place(Vertex v, const Placement& place);
  void grow();

  const OriginalSurface* surface_;
  HalfedgeMesh mesh_;
  VertexData<Vec3> position_;
  VertexData<Vec3> normal_;
  VertexData<Vec3> across_;
  VertexData<SurfacePoint> at_;
  VertexData<CurvePoint> on_;
  VertexData<VertexKind> kind_;
  VertexData<char> pinned_;
  VertexData<double> unrest_;
  HalfedgeData<Index> curve_;
};

}  // namespace remesher
