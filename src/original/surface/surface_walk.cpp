// SPDX-License-Identifier: MIT
#include "original/surface/surface_walk.h"

#include "geometry/triangle.h"

namespace remesher {

namespace {

class Walk {
 public:
  // barriers: null if there are none.
  struct Ground {
    const HalfedgeMesh& mesh;
    const VertexData<Vec3>& positions;
    const HalfedgeData<char>* barriers;
  };

  Walk(const Ground& ground, const Vec3& target, double enough = 0)
      : mesh_(ground.mesh),
        positions_(ground.positions),
        barriers_(ground.barriers),
        target_(target),
        squaredEnough_(enough * enough) {}

  // The end of the walk from a face.
  SurfacePoint from(Face start) const { return from(closestOn(start)); }

  // If the start is a vertex, all faces around it are tried first: at the end of a curve the
  // start's face may lie on the wrong side of the curve.
  SurfacePoint from(const SurfacePoint& start) const {
    const Vec3& w = start.barycentric;
    Found best = closestOn(start.face);
    for (int corner = 0; corner < 3; ++corner) {
      if (w[corner] != 1) continue;
      const Vec3& place = positions_[mesh_.vertices(start.face)[corner]];
      const Found around = closestAtVertex({start, target_ - place, 0}, corner);
      if (around.distance2 < best.distance2) best = around;
    }
    return from(best);
  }

 private:
  struct Found {
    SurfacePoint point;
    Vec3 toTarget = Vec3::Zero();  // from the point
    double distance2 = kInfinity;
  };

  SurfacePoint from(Found best) const {
    while (!(best.distance2 < squaredEnough_)) {
      const Found next = closestAround(best);
      if (!(next.distance2 < best.distance2)) break;
      best = next;
    }
    return best.point;
  }

  Found closestOn(Face f) const {
    const auto [a, b, c] = mesh_.vertices(f);
    const Vec3 &pa = positions_[a], &pb = positions_[b], &pc = positions_[c];
    Found found{{f, closestBarycentric(target_, pa, pb, pc)}, {}, 0};
    const Vec3& w = found.point.barycentric;
    found.toTarget = target_ - (w[0] * pa + w[1] * pb + w[2] * pc);
    found.distance2 = found.toTarget.squaredNorm();
    return found;
  }

  // The best point on the faces that touch the point found; infinitely far if none can be nearer.
  Found closestAround(const Found& found) const {
    const Vec3& w = found.point.barycentric;
    // A point on an edge may be moved off it by rounding: at a wall of 90° over the edge exactly
    // this point counts.
    const bool on[] = {w[0] < kRoundOff, w[1] < kRoundOff, w[2] < kRoundOff};
    const int edges = on[0] + on[1] + on[2];
    if (edges == 0) return {};
    if (edges == 1) return closestAcross(found, on[0] ? 1 : on[1] ? 2 : 0);
    return closestAtVertex(found, !on[0] ? 0 : !on[1] ? 1 : 2);
  }

  Halfedge across(Halfedge h) const {
    return barriers_ && (*barriers_)[h] ? Halfedge() : mesh_.twin(h);
  }

  // From a point inside the edge at `corner` only the face beyond the edge can be nearer, and only
  // if that face runs towards the target.
  Found closestAcross(const Found& found, int corner) const {
    const Halfedge h = across(HalfedgeMesh::halfedge(found.point.face, corner));
    if (!h || !ascends(found, mesh_.origin(h), mesh_.opposite(h))) return {};
    return closestOn(HalfedgeMesh::face(h));
  }

  Found closestAtVertex(const Found& found, int corner) const {
    const Halfedge start = HalfedgeMesh::halfedge(found.point.face, corner);
    Found best;
    Halfedge h = across(HalfedgeMesh::prev(start));
    for (; h && h != start; h = across(HalfedgeMesh::prev(h))) improve(found, h, best);
    if (h == start) return best;
    for (h = across(start); h; h = across(h)) {
      h = HalfedgeMesh::next(h);
      improve(found, h, best);
    }
    return best;
  }

  // The point found is the origin of h. If neither edge of the face there runs towards the target,
  // no point of the face is nearer.
  void improve(const Found& found, Halfedge h, Found& best) const {
    const Vertex v = mesh_.origin(h);
    if (!ascends(found, v, mesh_.tip(h)) && !ascends(found, v, mesh_.opposite(h))) return;
    const Found candidate = closestOn(HalfedgeMesh::face(h));
    if (candidate.distance2 < best.distance2) best = candidate;
  }

  bool ascends(const Found& found, Vertex from, Vertex to) const {
    return found.toTarget.dot(positions_[to] - positions_[from]) > 0;
  }

  const HalfedgeMesh& mesh_;
  const VertexData<Vec3>& positions_;
  const HalfedgeData<char>* barriers_;
  const Vec3& target_;
  const double squaredEnough_;
};

}  // namespace

SurfacePoint closestPointFrom(const OriginalSurface& surface, const SurfacePoint& start,
                              const Vec3& target) {
  return Walk({surface.mesh(), surface.positions(), &surface.barriers()}, target).from(start);
}

SurfacePoint closestPointFrom(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                              Face start, const Target& target) {
  return Walk({mesh, positions, nullptr}, target.position, target.enough).from(start);
}

}  // namespace remesher
