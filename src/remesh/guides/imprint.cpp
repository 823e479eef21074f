// SPDX-License-Identifier: MIT
#include "remesh/guides/imprint.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/fires.h"
#include "base/place.h"
#include "geometry/triangle.h"
#include "mesh/shortest_paths.h"

namespace remesher {

namespace {

// A point becomes a vertex that is nearer than this share of the edges there, so that no triangle
// gets thinner than need be.
constexpr double kSnap = 0.15;
// The end of an open line goes on to a boundary within this many times the distance that counts as
// near.
constexpr double kToBoundary = 10;
// A walk over more edges than this between two points has lost its way.
constexpr std::size_t kMostCrossed = 100000;

}  // namespace

Imprint::Imprint(const TriangleMesh& input, std::span<const std::pair<Index, Index>> edges,
                 double near)
    : given_(Index(input.positions.size())),
      near_(near),
      first_(weld(input.positions)),
      tree_(input.positions, input.indices) {
  mesh_.positions = input.positions;
  mesh_.indices = input.indices;
  mesh_.groups = input.groups;
  mesh_.isSingle = input.isSingle;
  mesh_.frame = input.frame;
  mesh_.steps = input.steps;
  around_.resize(input.positions.size());
  for (Index t = 0; t < input.triangleCount(); ++t) {
    parents_.push_back(t);
    for (const Index v : corners(t)) around_[v].push_back(t);
  }
  for (const auto& [a, b] : edges) mark(first_[a], first_[b]);
}

Imprint::Corners Imprint::corners(Index t) const {
  const Index* const wedges = &mesh_.indices[std::size_t{3} * t];
  return {first_[wedges[0]], first_[wedges[1]], first_[wedges[2]]};
}

Imprint::Weights Imprint::weightsOf(Index t) const {
  const auto found = weights_.find(t);
  return found != weights_.end() ? found->second
                                 : Weights{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
}

bool Imprint::areJoined(Index v, Index w) const {
  return std::any_of(around_[v].begin(), around_[v].end(), [&](Index t) {
    const Corners own = corners(t);
    return std::find(own.begin(), own.end(), w) != own.end();
  });
}

bool Imprint::isBoundary(Index v, Index w) const {
  return std::count_if(around_[v].begin(), around_[v].end(), [&](Index t) {
           const Corners own = corners(t);
           return std::find(own.begin(), own.end(), w) != own.end();
         }) == 1;
}

Vec3 Imprint::normalNear(Index v) const {
  Vec3 sum = Vec3::Zero();
  for (const Index t : around_[v]) {
    const auto [a, b, c] = corners(t);
    sum += unitNormal(at(a), at(b), at(c));
  }
  return sum;
}

InputPlace Imprint::onInput(const InputPlace& place) const {
  const Weights weights = weightsOf(place.triangle.index);
  Vec3 sum = Vec3::Zero();
  for (Eigen::Index k = 0; k < 3; ++k) sum += place.weights[k] * weights[std::size_t(k)];
  return {InputTriangle{parents_[place.triangle.index]}, sum};
}

Index Imprint::addVertex(const Vec3& p, const InputPlace& place) {
  mesh_.positions.push_back(p);
  places_.push_back(place);
  const auto v = Index(mesh_.positions.size() - 1);
  first_.push_back(v);
  around_.emplace_back();
  return v;
}

void Imprint::setTriangle(Index t, const Corners& wedges, const Weights& weights) {
  for (std::size_t k = 0; k < 3; ++k) mesh_.indices[std::size_t{3} * t + k] = wedges[k];
  weights_[t] = weights;
}

Index Imprint::addTriangle(Index like, const Corners& wedges, const Weights& weights) {
  const auto t = Index(parents_.size());
  parents_.push_back(parents_[like]);
  auto& children = children_[parents_[like]];
  if (children.empty()) children.push_back(parents_[like]);
  children.push_back(t);
  mesh_.indices.insert(mesh_.indices.end(), wedges.begin(), wedges.end());
  if (!mesh_.groups.empty()) mesh_.groups.push_back(mesh_.groups[like]);
  weights_[t] = weights;
  for (const Index v : corners(t)) around_[v].push_back(t);
  return t;
}

// Divides all triangles at the edge; where their own vertices differ, as along seams, so do those
// in the middle.
Index Imprint::splitEdge(Index a, Index b, double t) {
  if (b < a) return splitEdge(b, a, 1 - t);
  const Vec3 p = at(a) + t * (at(b) - at(a));
  std::map<std::pair<Index, Index>, Index> middles;  // by the wedges at both ends
  Index middle = kNone;
  const std::vector<Index> triangles = around_[a];
  for (const Index f : triangles) {
    const Corners own = corners(f);
    const auto i = std::size_t(std::find(own.begin(), own.end(), a) - own.begin());
    const auto j = std::size_t(std::find(own.begin(), own.end(), b) - own.begin());
    if (j == 3) continue;
    const Index* const given = &mesh_.indices[std::size_t{3} * f];
    const Corners wedges = {given[0], given[1], given[2]};
    const Weights weights = weightsOf(f);
    const Vec3 between = (1 - t) * weights[i] + t * weights[j];
    const auto [entry, isNew] = middles.try_emplace({wedges[i], wedges[j]}, kNone);
    if (isNew) {
      entry->second = addVertex(p, {InputTriangle{parents_[f]}, between});
      if (middle == kNone) middle = entry->second;
      first_[entry->second] = middle;
    }
    Corners here = wedges, there = wedges;
    Weights ofHere = weights, ofThere = weights;
    here[j] = there[i] = entry->second;
    ofHere[j] = ofThere[i] = between;
    setTriangle(f, here, ofHere);
    std::erase(around_[b], f);
    around_[middle].push_back(f);
    addTriangle(f, there, ofThere);
  }
  if (edges_.erase(std::minmax(a, b)) > 0) {
    mark(a, middle);
    mark(middle, b);
  }
  return middle;
}

Index Imprint::splitFace(Index t, const Vec3& inside) {
  const Index* const given = &mesh_.indices[std::size_t{3} * t];
  const Corners wedges = {given[0], given[1], given[2]}, own = corners(t);
  const Weights weights = weightsOf(t);
  Vec3 p = Vec3::Zero(), place = Vec3::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    p += inside[Eigen::Index(k)] * at(own[k]);
    place += inside[Eigen::Index(k)] * weights[k];
  }
  const Index middle = addVertex(p, {InputTriangle{parents_[t]}, place});
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
    Corners there = wedges;
    Weights ofThere = weights;
    there[k] = middle;
    ofThere[k] = place;
    addTriangle(t, there, ofThere);
  }
  Corners here = wedges;
  Weights ofHere = weights;
  here[2] = middle;
  ofHere[2] = place;
  setTriangle(t, here, ofHere);
  std::erase(around_[own[2]], t);
  around_[middle].push_back(t);
  return middle;
}

// The vertex for a point of the triangle: a near one, or a new one on an edge or inside.
Index Imprint::snapped(Index t, const Vec3& p) {
  const Corners own = corners(t);
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k)
    longest = std::max(longest, distance(at(own[k]), at(own[(k + 1) % 3])));
  const double near = std::min(near_, kSnap * longest);
  for (const Index v : own)
    if (distance(at(v), p) <= near) return v;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &a = at(own[k]), &b = at(own[(k + 1) % 3]);
    const Vec3 side = b - a;
    const double along = (p - a).dot(side) / side.squaredNorm();
    if (along > 0 && along < 1 && distance(p, a + along * side) <= near)
      return splitEdge(own[k], own[(k + 1) % 3], along);
  }
  return splitFace(t, closestBarycentric(p, at(own[0]), at(own[1]), at(own[2])));
}

Index Imprint::vertexAt(const Vec3& p) {
  const Index parent = tree_.nearest(p).triangle;
  const auto found = children_.find(parent);
  Index best = parent;
  double least = kInfinity;
  if (found != children_.end())
    for (const Index t : found->second) {
      const auto [a, b, c] = corners(t);
      const double away = distance(p, closestPoint(p, at(a), at(b), at(c)));
      if (away < least) std::tie(best, least) = std::tie(t, away);
    }
  return snapped(best, p);
}

// The vertex for the end of an open line: on a boundary that is near, as where a half is cut off.
Index Imprint::endAt(const Vec3& p) {
  double least = kToBoundary * near_, along = 0;
  Index a = kNone, b = kNone;
  for (Index t = 0; t < parents_.size(); ++t) {
    const Corners own = corners(t);
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = own[k], w = own[(k + 1) % 3];
      const Vec3 side = at(w) - at(v);
      const double share = std::clamp((p - at(v)).dot(side) / side.squaredNorm(), 0.0, 1.0);
      const double away = distance(p, at(v) + share * side);
      if (!(away < least) || !isBoundary(v, w)) continue;
      std::tie(least, along, a, b) = std::tuple(away, share, v, w);
    }
  }
  if (a == kNone) return vertexAt(p);
  const double length = distance(at(a), at(b)), near = std::min(near_, kSnap * length);
  if (along * length <= near) return a;
  return (1 - along) * length <= near ? b : splitEdge(a, b, along);
}

// Where the plane leaves the triangles around a vertex towards its target: the place nearest to
// that.
Imprint::Crossing Imprint::crossingFrom(Index v, const Plane& plane) const {
  Crossing best;
  const double whole = distance(at(v), plane.target);
  for (const Index f : around_[v]) {
    const Corners own = corners(f);
    const auto i = std::size_t(std::find(own.begin(), own.end(), v) - own.begin());
    const Index a = own[(i + 1) % 3], b = own[(i + 2) % 3];
    if (a == b || a == v || b == v) continue;
    const double before = plane.normal.dot(at(a) - plane.target);
    const double after = plane.normal.dot(at(b) - plane.target);
    if (before * after > 0 || before == after) continue;
    const double t = before / (before - after);
    const double left = distance(at(a) + t * (at(b) - at(a)), plane.target);
    if (left < best.left && left < whole) best = {a, b, t, left};
  }
  return best;
}

// Makes edges of the section of the surface by a plane through both vertices.
bool Imprint::walk(Index from, Index to, std::vector<Index>& path) {
  const Vec3 across = (at(to) - at(from)).cross(normalNear(from) + normalNear(to));
  if (!(across.norm() > 0)) return false;
  const Plane plane = {across.normalized(), at(to)};
  Index v = from;
  for (std::size_t i = 0; i < kMostCrossed && v != to; ++i) {
    Index next = to;
    if (!areJoined(v, to)) {
      const Crossing crossing = crossingFrom(v, plane);
      if (crossing.a == kNone) return false;
      const double length = distance(at(crossing.a), at(crossing.b));
      const double near = std::min(near_, kSnap * length), whole = distance(at(v), at(to));
      const auto isNear = [&](Index w, double away) {
        return away <= near && distance(at(w), at(to)) < whole;
      };
      if (isNear(crossing.a, crossing.t * length))
        next = crossing.a;
      else if (isNear(crossing.b, (1 - crossing.t) * length))
        next = crossing.b;
      else
        next = splitEdge(crossing.a, crossing.b, crossing.t);
    }
    path.push_back(v = next);
  }
  return v == to;
}

// The shortest way along edges.
bool Imprint::follow(Index from, Index to, std::vector<Index>& path) const {
  fires("guides: along edges");
  ShortestPaths paths(around_.size());
  VertexData<Index> before(around_.size(), kNone);
  paths.reach(Vertex(from), 0);
  for (Vertex v; (v = paths.leave()) && v.index != to;)
    for (const Index f : around_[v.index])
      for (const Index w : corners(f))
        if (paths.reach(Vertex(w), paths[v] + distance(at(v.index), at(w))))
          before[Vertex(w)] = v.index;
  if (paths[Vertex(to)] == kInfinity) return false;
  std::vector<Index> back;
  for (Index v = to; v != from; v = before[Vertex(v)]) back.push_back(v);
  path.insert(path.end(), back.rbegin(), back.rend());
  return true;
}

Guide Imprint::add(const Guide& guide) {
  std::vector<Index> stops, path;
  for (const Vec3& p : guide.points) {
    const bool isEnd = &p == &guide.points.front() || &p == &guide.points.back();
    const Index v = isEnd && !guide.isClosed ? endAt(p) : vertexAt(p);
    if (stops.empty() || stops.back() != v) stops.push_back(v);
  }
  Guide made = guide;
  made.points.clear();
  if (guide.isClosed && stops.size() > 1 && stops.front() != stops.back())
    stops.push_back(stops.front());
  if (stops.size() < (guide.isClosed ? 4U : 2U)) return made;
  path.push_back(stops.front());
  for (std::size_t i = 1; i < stops.size(); ++i) {
    const std::size_t before = path.size();
    if (walk(path.back(), stops[i], path)) continue;
    path.resize(before);
    if (!follow(path.back(), stops[i], path)) return made;
  }
  for (std::size_t i = 1; i < path.size(); ++i) mark(path[i - 1], path[i]);
  if (guide.isClosed) path.pop_back();
  for (const Index v : path) made.points.push_back(at(v));
  return made;
}

}  // namespace remesher
