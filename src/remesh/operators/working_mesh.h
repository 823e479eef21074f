// SPDX-License-Identifier: MIT
// The mesh being remeshed: connectivity, and for every vertex its place on the original surface
// [DGP 2016, "Projection on the Initial Surface"]. Each vertex has a VertexKind, and each edge
// knows the feature curve that it follows, if any. Only the commands at the end change the mesh;
// the operators (legality) and the fidelity gate (geometry) decide beforehand what is allowed.
#pragma once

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
  Vec3 normal = Vec3::Zero();  // the original's, unit; of a vertex on a curve: on one side
  SurfacePoint at;
  CurvePoint on;
  VertexKind kind = VertexKind::Interior;
  Vec3 across = Vec3::Zero();  // of a vertex on a curve: the normal on the other side
};

class WorkingMesh {
 public:
  // A copy of the original: every vertex at its own place. `surface` must outlive the mesh.
  explicit WorkingMesh(const OriginalSurface& surface);

  // Another mesh on the original, compact: three corners per triangle; per halfedge its twin and
  // the chain that its edge follows, or kNone; per vertex its place.
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
  // The sum of the area vectors of the triangles around v, and the mean length of its edges.
  Vec3 areaVectorAround(Vertex v) const;
  double meanSpoke(Vertex v) const;
  double edgeLength(Halfedge h) const {
    return (position(mesh_.tip(h)) - position(mesh_.origin(h))).norm();
  }
  VertexKind kind(Vertex v) const { return kind_[v]; }
  const SurfacePoint& at(Vertex v) const { return at_[v]; }
  const CurvePoint& on(Vertex v) const { return on_[v]; }
  Placement placement(Vertex v) const;
  bool isPinned(Vertex v) const { return pinned_[v]; }  // smoothing leaves it alone

  // The summed moves of v's neighbours since v was last settled; infinite if its star has changed.
  // move() does not count by itself: a caller that needs it calls stirNeighbors().
  double unrest(Vertex v) const { return unrest_[v]; }

  // The chain that the edge of h follows, or kNone.
  Index curve(Halfedge h) const { return curve_[h]; }
  bool isCurve(Halfedge h) const { return curve_[h] != kNone; }
  // Whether no part of a curve has been released.
  bool followsAll() const { return followsAll_; }
  // Whether the edge of h belongs to a curve that stays as it is.
  bool isKept(Halfedge h) const {
    return isCurve(h) && surface_->curves().chains()[curve_[h]].kept;
  }

  // The original's vertex nearest to a point by barycentric weight; for a corner, the one it lies
  // on.
  Vertex originalCorner(const SurfacePoint& at) const;

  // The place of v on `chain`; v lies on the chain or is one of its ends.
  CurvePoint onChain(Vertex v, Index chain) const;

  // The original's point under the corner of face(h) at origin(h). For a vertex on a curve it is
  // the point on the corner's own side, found by turning clockwise around the vertex to the nearest
  // curve edge.
  SurfacePoint cornerPoint(Halfedge h) const;

  // The full placement of a point of the surface or of a curve.
  Placement onSurface(const SurfacePoint& point) const;
  Placement onCurve(const CurvePoint& point) const;

  // The original's unit normal under a corner of a triangle with normal `n`: of a vertex on a curve
  // or of a corner, the one closest to `n` of the normals on all sides.
  Vec3 normalFacing(Vertex v, const Vec3& n) const;
  Vec3 normalFacing(const Placement& place, const Vec3& n) const;

  Halfedge flip(Halfedge h);                                         // returns the new edge
  EulerOperators::Split split(Halfedge h, const Placement& middle);  // the new vertex at `middle`
  Vertex collapse(Halfedge h, const Placement& merged);              // tip(h) remains, at `merged`
  void move(Vertex v, const Placement& place);
  void release(Vertex v);  // from its curves: they end at its neighbours, which are pinned
  void pin(Vertex v) { pinned_[v] = 1; }
  void settle(Vertex v) { unrest_[v] = 0; }
  void stirNeighbors(Vertex v, double moved);  // v moved by `moved`
  void unsettleStar(Vertex v);                 // v and its neighbours
  void unsettleAll() { unrest_.assign(unrest_.size(), kInfinity); }
  void settleAll() { unrest_.assign(unrest_.size(), 0); }

  // Each triangle becomes four. midpoints[i] is the place of the middle of the i-th edge, in the
  // order of the edges' halfedges. The mesh must be compact.
  void subdivide(std::span<const Placement> midpoints);

  // Moves the mesh onto another surface with the same curves: each vertex to its point of `points`.
  // Vertices on curves keep their places along the curves.
  void moveOnto(const OriginalSurface& surface, const VertexData<SurfacePoint>& points);

  // Closes the holes that deletions left.
  void compact();

 private:
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
  bool followsAll_ = true;
};

}  // namespace remesher
