// SPDX-License-Identifier: MIT
// Triangles are sampled at their corners, along their sides and in the middle: where these all lie
// near the original, so does the rest.
#include "remesh/accuracy/two_sided_distance.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "geometry/triangle.h"
#include "original/surface/surface_walk.h"

namespace remesher {

TwoSidedDistance::TwoSidedDistance(const Run& run)
    : mesh_(run.mesh),
      hubs_(Hubs::ofWalks(run.mesh.mesh())),
      doubtful_(kDoubtful * run.sizes.mean()),
      originalIsCoarse_(mesh_.surface().mesh().vertexCount() < mesh_.mesh().vertexCount()),
      // Near the tangent plane of a vertex is not near the mesh where the surface bends within an
      // edge: at tips, the spots that decide the largest distance. So no place is skipped.
      places_(measurePlaces(run, kPlainlyNear, 0)),
      next_(places_.size(), kNone),
      first_(mesh_.mesh().faceCapacity(), kNone),
      distance_(mesh_.mesh().faceCapacity(), 0),
      tree_(run.grounds.tree ? *run.grounds.tree : own_.emplace(mesh_.surface())) {
  measureFaces();
  for (Index i = 0; i < places_.size(); ++i) add(i);
}

// For a vertex whose move is asked about, walks start from its new place, as they will after the
// move.
SurfacePoint TwoSidedDistance::startAt(Halfedge corner) const {
  const bool wouldMove = mesh_.mesh().origin(corner) == moved_ && to_.kind == VertexKind::Interior;
  return wouldMove ? to_.at : mesh_.cornerPoint(corner);
}

// The start of a walk: the place of the corner of f that is nearest to a sample; a hub only if all
// corners are hubs.
SurfacePoint TwoSidedDistance::startNear(const Vec3& sample, Face f) const {
  const Triangle corners = mesh_.corners(f);
  const auto vertices = mesh_.mesh().vertices(f);
  const auto distance2 = [&](int i) {
    return hubs_.contains(vertices[i]) ? kInfinity : (corners[i] - sample).squaredNorm();
  };
  int nearest = 0;
  for (const int i : {1, 2})
    if (distance2(i) < distance2(nearest)) nearest = i;
  return startAt(HalfedgeMesh::halfedge(f, nearest));
}

// The distance by a walk from `place`, which becomes the end of the walk. If that is doubtfully
// far, the whole original is searched.
double TwoSidedDistance::fromOriginal(const Vec3& sample, SurfacePoint& place) const {
  const OriginalSurface& surface = mesh_.surface();
  place = closestPointFrom(surface, place, sample);
  const double nearest = (surface.position(place) - sample).norm();
  if (nearest <= doubtful_) return nearest;
  const OriginalTree::Nearest found = tree_.nearest(sample, place.face);
  looked_ += found.looked;
  return found.distance;
}

double TwoSidedDistance::fromOriginal(const Vec3& sample, Face f) const {
  SurfacePoint place = startNear(sample, f);
  return fromOriginal(sample, place);
}

// The samples lie side by side: each walk begins where the one before ended.
double TwoSidedDistance::fromOriginal(const Vec3& from, const Vec3& to, Face f,
                                      double limit) const {
  double farthest = 0;
  const auto measure = [&](std::initializer_list<double> shares) {
    SurfacePoint place = startNear(from, f);
    for (const double t : shares) {
      farthest = std::max(farthest, fromOriginal((1 - t) * from + t * to, place));
      if (farthest > limit) return;
    }
  };
  measure({0.25, 0.5, 0.75});
  if (farthest > doubtful_ && farthest <= limit) measure({0.125, 0.375, 0.625, 0.875});
  return farthest;
}

double TwoSidedDistance::fromOriginal(const Triangle& triangle, Face f) const {
  return fromOriginal((triangle[0] + triangle[1] + triangle[2]) / 3, f);
}

// Whether an edge lies in the tangent planes at both its ends. If the original is no coarser than
// the mesh, such an edge cannot be far off in between, and a bump would be found from the original.
bool TwoSidedDistance::followsOriginal(Halfedge h) const {
  const Vertex a = mesh_.mesh().origin(h), b = mesh_.mesh().tip(h);
  if (originalIsCoarse_ || mesh_.kind(a) != VertexKind::Interior ||
      mesh_.kind(b) != VertexKind::Interior)
    return false;
  const Vec3 edge = mesh_.position(b) - mesh_.position(a);
  const double most = kPlainlyNear * edge.norm();
  return std::abs(edge.dot(mesh_.normal(a))) < most && std::abs(edge.dot(mesh_.normal(b))) < most;
}

void TwoSidedDistance::raise(Face f, double distance) {
  distance_[f] = std::max(distance_[f], distance);
}

// Corners and sides are measured once for all triangles that share them; sides and middles only
// where the original may bend away from a side.
void TwoSidedDistance::measureFaces() {
  const HalfedgeMesh& m = mesh_.mesh();
  FaceData<char> bent(m.faceCapacity(), 0);
  for (Index i = 0; i < m.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    if (!m.isEdge(h) || followsOriginal(h)) continue;
    const Vec3 &from = mesh_.position(m.origin(h)), &to = mesh_.position(m.tip(h));
    const double distance = fromOriginal(from, to, m.face(h));
    for (const Halfedge side : {h, m.twin(h)}) {
      if (!side) continue;
      raise(m.face(side), distance);
      bent[m.face(side)] = 1;
    }
  }
  for (Index i = 0; i < m.vertexCapacity(); ++i) {
    const Vertex v(i);
    if (!m.isAlive(v)) continue;
    double distance = (mesh_.surface().position(mesh_.at(v)) - mesh_.position(v)).norm();
    if (distance > doubtful_) distance = fromOriginal(mesh_.position(v), m.face(m.outgoing(v)));
    m.forEachOutgoing(v, [&](Halfedge h) { raise(m.face(h), distance); });
  }
  for (Index i = 0; i < m.faceCapacity(); ++i) {
    if (!m.isAlive(Face(i)) || !bent[Face(i)]) continue;
    const auto [a, b, c] = m.vertices(Face(i));
    raise(Face(i),
          fromOriginal({mesh_.position(a), mesh_.position(b), mesh_.position(c)}, Face(i)));
  }
}

void TwoSidedDistance::add(Index place) {
  const Place& p = places_[place];
  next_[place] = first_[p.nearest];
  first_[p.nearest] = place;
  raise(p.nearest, p.distance);
}

void TwoSidedDistance::gather(Vertex v, const Placement& to) {
  const HalfedgeMesh& m = mesh_.mesh();
  gathered_.clear();
  moved_ = v;
  to_ = to;
  m.forEachOutgoing(v, [&](Halfedge h) {
    gathered_.push_back(
        {m.face(h), {to.position, mesh_.position(m.tip(h)), mesh_.position(m.opposite(h))}});
  });
}

// Measures the place against the gathered triangles.
void TwoSidedDistance::measureNear(Place& place) const {
  double nearest = kInfinity;
  for (const auto& [face, at] : gathered_) {
    const double distance2 =
        (closestPoint(place.position, at[0], at[1], at[2]) - place.position).squaredNorm();
    if (distance2 >= nearest) continue;
    nearest = distance2;
    place.nearest = face;
  }
  place.distance = std::sqrt(nearest);
}

bool TwoSidedDistance::isGathered(Face f) const {
  return std::any_of(gathered_.begin(), gathered_.end(),
                     [f](const Changed& triangle) { return triangle.face == f; });
}

double TwoSidedDistance::distanceNear(Place place) const {
  measureNear(place);
  return place.distance;
}

// Whether a place is at most `distance` from some gathered triangle. Its own triangle is tried
// first, because that is usually near enough.
bool TwoSidedDistance::isNear(const Place& place, const Changed& own, double distance) const {
  const auto isWithin = [&](const Changed& triangle) {
    const auto& [a, b, c] = triangle.at;
    return (closestPoint(place.position, a, b, c) - place.position).norm() <= distance;
  };
  return isWithin(own) || std::any_of(gathered_.begin(), gathered_.end(), isWithin);
}

// The largest distance of places that belong to the gathered triangles; above `limit` it may be any
// value above it. The place that exceeded a limit last is tried first: it is likely to do so again.
double TwoSidedDistance::farthestPlace(double limit) {
  double farthest = 0;
  if (tooFar_ != kNone && isGathered(places_[tooFar_].nearest)) {
    farthest = distanceNear(places_[tooFar_]);
    if (farthest > limit) return farthest;
  }
  for (const Changed& triangle : gathered_)
    for (Index i = first_[triangle.face]; i != kNone; i = next_[i]) {
      if (isNear(places_[i], triangle, farthest)) continue;
      farthest = std::max(farthest, distanceNear(places_[i]));
      if (farthest <= limit) continue;
      tooFar_ = i;
      return farthest;
    }
  return farthest;
}

double TwoSidedDistance::around(Vertex v, const Placement& to, double limit) {
  gather(v, to);
  double farthest = farthestPlace(limit);
  if (farthest > limit) return farthest;
  farthest = std::max(farthest, fromOriginal(to.position, gathered_[0].face));
  for (const auto& [face, at] : gathered_) {
    if (farthest > limit) break;
    farthest =
        std::max({farthest, fromOriginal(at, face), fromOriginal(at[0], at[1], face, limit)});
    if (mesh_.mesh().isBoundary(v))
      farthest = std::max(farthest, fromOriginal(at[0], at[2], face, limit));
  }
  return farthest;
}

double TwoSidedDistance::onRim(Vertex v) {
  gather(v, mesh_.placement(v));
  double farthest = 0;
  for (const auto& [face, at] : gathered_)
    farthest = std::max({farthest, fromOriginal(at[1], face), fromOriginal(at[1], at[2], face)});
  return farthest;
}

double TwoSidedDistance::ifFlipped(Halfedge h) {
  const HalfedgeMesh& m = mesh_.mesh();
  const Halfedge t = m.twin(h);
  const Vec3 &a = mesh_.position(m.origin(h)), &b = mesh_.position(m.tip(h));
  const Vec3 &c = mesh_.position(m.opposite(h)), &d = mesh_.position(m.opposite(t));
  moved_ = {};
  gathered_ = {{m.face(h), {a, d, c}}, {m.face(t), {b, c, d}}};
  double farthest = std::max(farthestPlace(kInfinity), fromOriginal(d, c, m.face(h)));
  for (const auto& [face, at] : gathered_)
    farthest = std::max({farthest, fromOriginal(at, face), fromOriginal(at[0], face),
                         fromOriginal(at[1], face), fromOriginal(at[0], at[1], face),
                         fromOriginal(at[2], at[0], face)});
  return farthest;
}

void TwoSidedDistance::measureGathered() {
  moving_.clear();
  for (const auto& [face, at] : gathered_) {
    for (Index i = first_[face]; i != kNone; i = next_[i]) moving_.push_back(i);
    first_[face] = kNone;
    distance_[face] = fromOriginal(at, face);
    for (int i = 0; i < 3; ++i) {
      raise(face, fromOriginal(at[i], face));
      raise(face, fromOriginal(at[i], at[(i + 1) % 3], face));
    }
  }
  for (const Index i : moving_) {
    measureNear(places_[i]);
    add(i);
  }
}

void TwoSidedDistance::update(Vertex v) {
  gather(v, mesh_.placement(v));
  measureGathered();
}

void TwoSidedDistance::update(Halfedge h) {
  gathered_.clear();
  moved_ = {};
  for (const Face f : {HalfedgeMesh::face(h), HalfedgeMesh::face(mesh_.mesh().twin(h))}) {
    const auto [a, b, c] = mesh_.mesh().vertices(f);
    gathered_.push_back({f, {mesh_.position(a), mesh_.position(b), mesh_.position(c)}});
  }
  measureGathered();
}

}  // namespace remesher
