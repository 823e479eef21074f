// SPDX-License-Identifier: MIT
#include "remesh/operators/working_mesh.h"

namespace remesher {

WorkingMesh::WorkingMesh(const OriginalSurface& surface)
    : surface_(&surface),
      mesh_(surface.mesh()),
      position_(surface.positions()),
      normal_(mesh_.vertexCapacity()),
      across_(mesh_.vertexCapacity()),
      at_(mesh_.vertexCapacity()),
      on_(mesh_.vertexCapacity()),
      kind_(mesh_.vertexCapacity(), VertexKind::Interior),
      pinned_(mesh_.vertexCapacity(), 0),
      unrest_(mesh_.vertexCapacity(), kInfinity),
      curve_(mesh_.halfedgeCapacity(), kNone) {
  for (Index i = 0; i < mesh_.vertexCapacity(); ++i) {
    if (!mesh_.isAlive(Vertex(i))) continue;
    at_[Vertex(i)] = surface.at(Vertex(i));
    normal_[Vertex(i)] = surface.cornerNormal(mesh_.outgoing(Vertex(i)));
  }
  for (Index i = 0; i < mesh_.halfedgeCapacity(); ++i)
    curve_[Halfedge(i)] = surface.curves().chain(Halfedge(i));
  for (Index i = 0; i < mesh_.vertexCapacity(); ++i)
    if (surface.curves().isCorner(Vertex(i))) kind_[Vertex(i)] = VertexKind::Corner;
  const auto& chains = surface.curves().chains();
  for (Index c = 0; c < chains.size(); ++c)
    for (std::size_t i = 1; i + 1 < chains[c].vertices.size(); ++i)
      place(chains[c].vertices[i], onCurve({c, chains[c].arcs[i]}));
}

WorkingMesh::WorkingMesh(const OriginalSurface& surface, const Parts& parts)
    : surface_(&surface), mesh_(parts.places.size(), parts.triangles, parts.twins) {
  grow();
  for (Index v = 0; v < parts.places.size(); ++v) place(Vertex(v), parts.places[v]);
  for (Index h = 0; h < parts.curves.size(); ++h) curve_[Halfedge(h)] = parts.curves[h];
}

Vec3 WorkingMesh::areaVectorAround(Vertex v) const {
  const Vec3& at = position(v);
  Vec3 sum = Vec3::Zero();
  mesh_.forEachOutgoing(v, [&](Halfedge h) {
    sum += areaVector(at, position(mesh_.tip(h)), position(mesh_.opposite(h)));
  });
  return sum;
}

double WorkingMesh::meanSpoke(Vertex v) const {
  double sum = 0;
  mesh_.forEachNeighbor(v, [&](Vertex w) { sum += (position(w) - position(v)).norm(); });
  return sum / mesh_.valence(v);
}

Placement WorkingMesh::placement(Vertex v) const {
  if (kind_[v] != VertexKind::Curve) return {position_[v], normal_[v], at_[v], {}, kind_[v]};
  return {position_[v], normal_[v], at_[v], on_[v], kind_[v], across_[v]};
}

Vertex WorkingMesh::originalCorner(const SurfacePoint& at) const {
  int corner = 0;
  at.barycentric.maxCoeff(&corner);
  return surface_->mesh().vertices(at.face)[corner];
}

CurvePoint WorkingMesh::onChain(Vertex v, Index chain) const {
  if (kind_[v] == VertexKind::Curve) return on_[v];
  return surface_->curves().atCorner(chain, originalCorner(at_[v]));
}

SurfacePoint WorkingMesh::cornerPoint(Halfedge h) const {
  const Vertex v = mesh_.origin(h);
  if (kind_[v] == VertexKind::Interior) return at_[v];
  Halfedge edge = h;
  while (!isCurve(edge)) {
    // A tip is on no curve; neither are boundaries that quads do not follow.
    if (mesh_.isBoundary(edge)) return at_[v];
    edge = mesh_.next(mesh_.twin(edge));
    if (edge == h) return at_[v];
  }
  const Index chain = curve_[edge];
  const CurvePoint here = onChain(v, chain), there = onChain(mesh_.tip(edge), chain);
  return surface_->curves().leftOf(surface_->mesh(), here, there);
}

Placement WorkingMesh::onSurface(const SurfacePoint& point) const {
  return {surface_->position(point), surface_->normal(point).normalized(), point, {}, {}, {}};
}

Placement WorkingMesh::onCurve(const CurvePoint& point) const {
  const HalfedgeMesh& original = surface_->mesh();
  const auto [position, at, edge] =
      surface_->curves().locate(original, surface_->positions(), point);
  const Vec3 normal = surface_->normal(at).normalized();
  const Halfedge twin = original.twin(edge);
  if (!twin) return {position, normal, at, point, VertexKind::Curve, normal};
  // The edge's two ends lie at swapped corners on its other side.
  const double atOrigin = at.barycentric[int(edge.index % 3)];
  const Vec3 across = (atOrigin * surface_->cornerNormal(original.next(twin)) +
                       (1 - atOrigin) * surface_->cornerNormal(twin))
                          .normalized();
  return {position, normal, at, point, VertexKind::Curve, across};
}

Vec3 WorkingMesh::normalFacing(Vertex v, const Vec3& n) const {
  return kind_[v] == VertexKind::Interior ? normal_[v] : normalFacing(placement(v), n);
}

Vec3 WorkingMesh::normalFacing(const Placement& place, const Vec3& n) const {
  if (place.kind == VertexKind::Interior) return place.normal;
  Vec3 best = place.normal;
  const auto consider = [&](const Vec3& candidate) {
    if (candidate.dot(n) > best.dot(n)) best = candidate;
  };
  if (place.kind == VertexKind::Curve)
    consider(place.across);
  else
    surface_->mesh().forEachOutgoing(originalCorner(place.at),
                                     [&](Halfedge h) { consider(surface_->cornerNormal(h)); });
  return best;
}

void WorkingMesh::place(Vertex v, const Placement& place) {
  position_[v] = place.position;
  normal_[v] = place.normal;
  at_[v] = place.at;
  kind_[v] = place.kind;
  if (place.kind != VertexKind::Curve) return;  // others have no more than that
  across_[v] = place.across;
  on_[v] = place.on;
}

void WorkingMesh::grow() {
  const std::size_t vertices = mesh_.vertexCapacity();
  if (position_.size() < vertices) {
    position_.resize(vertices);
    normal_.resize(vertices);
    across_.resize(vertices);
    at_.resize(vertices);
    on_.resize(vertices);
    kind_.resize(vertices);
    pinned_.resize(vertices, 0);
    unrest_.resize(vertices, kInfinity);
  }
  if (curve_.size() < mesh_.halfedgeCapacity()) curve_.resize(mesh_.halfedgeCapacity(), kNone);
}

void WorkingMesh::unsettleStar(Vertex v) {
  unrest_[v] = kInfinity;
  mesh_.forEachNeighbor(v, [&](Vertex w) { unrest_[w] = kInfinity; });
}

void WorkingMesh::stirNeighbors(Vertex v, double moved) {
  mesh_.forEachNeighbor(v, [&](Vertex w) { unrest_[w] += moved; });
}

Halfedge WorkingMesh::flip(Halfedge h) {
  const Halfedge t = mesh_.twin(h);
  const Halfedge edge = EulerOperators(mesh_).flip(h);
  // The slots of the old outer edges now hold the new inner one.
  const Halfedge back = mesh_.twin(edge);
  curve_[h] = curve_[back];
  curve_[t] = curve_[edge];
  curve_[edge] = curve_[back] = kNone;
  for (const Halfedge side : {edge, back})
    unrest_[mesh_.origin(side)] = unrest_[mesh_.opposite(side)] = kInfinity;
  return edge;
}

EulerOperators::Split WorkingMesh::split(Halfedge h, const Placement& middle) {
  const Index chain = curve_[h];
  const Halfedge t = mesh_.twin(h);
  const Index upper = curve_[mesh_.next(h)], lower = t ? curve_[mesh_.prev(t)] : kNone;
  const EulerOperators::Split made = EulerOperators(mesh_).split(h);
  grow();
  curve_[made.beyond] = chain;
  curve_[mesh_.next(made.beyond)] = upper;
  curve_[mesh_.prev(made.beyond)] = curve_[mesh_.next(h)] = kNone;
  if (t) {
    const Halfedge below = mesh_.twin(made.beyond);
    curve_[below] = chain;
    curve_[mesh_.prev(below)] = lower;
    curve_[mesh_.next(below)] = curve_[mesh_.prev(t)] = kNone;
  }
  place(made.vertex, middle);
  pinned_[made.vertex] = 0;
  unsettleStar(made.vertex);
  return made;
}

Vertex WorkingMesh::collapse(Halfedge h, const Placement& merged) {
  // On each side two edges become one. If either follows a curve, so does the remaining edge.
  for (const Halfedge side : {h, mesh_.twin(h)}) {
    if (!side) continue;
    const Halfedge second = mesh_.next(side), third = mesh_.prev(side);
    const Index chain = isCurve(second) ? curve_[second] : curve_[third];
    for (const Halfedge edge : {second, third})
      if (mesh_.twin(edge)) curve_[mesh_.twin(edge)] = chain;
    curve_[side] = curve_[second] = curve_[third] = kNone;
  }
  const bool pinned = pinned_[mesh_.origin(h)] || pinned_[mesh_.tip(h)];
  const Vertex remaining = EulerOperators(mesh_).collapse(h);
  pinned_[remaining] = pinned;
  place(remaining, merged);
  unsettleStar(remaining);
  return remaining;
}

void WorkingMesh::release(Vertex v) {
  mesh_.forEachOutgoing(v, [&](Halfedge h) {
    if (!isCurve(h)) return;
    followsAll_ = false;
    pin(mesh_.tip(h));
    curve_[h] = kNone;
    if (mesh_.twin(h)) curve_[mesh_.twin(h)] = kNone;
  });
  kind_[v] = VertexKind::Interior;
}

void WorkingMesh::move(Vertex v, const Placement& to) { place(v, to); }

namespace {

// The triangle with corners 0, 1, 2 and side midpoints m0, m1, m2 becomes (0 m0 m2) (1 m1 m0) (2 m2
// m1) (m0 m1 m2). Its side from i to i + 1 becomes the first halfedge of the i-th triangle and the
// last of the next.
std::vector<Index> subdividedTwins(const HalfedgeMesh& mesh) {
  std::vector<Index> twins(4 * mesh.halfedgeCapacity(), kNone);
  const auto firstHalf = [](Halfedge h) { return 12 * (h.index / 3) + 3 * (h.index % 3); };
  const auto secondHalf = [](Halfedge h) {
    return 12 * (h.index / 3) + 3 * ((h.index + 1) % 3) + 2;
  };
  for (Index i = 0; i < mesh.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    const Index inner = firstHalf(h) + 1, middle = 12 * (i / 3) + 9 + (i + 2) % 3;
    twins[inner] = middle;
    twins[middle] = inner;
    if (mesh.isBoundary(h)) continue;
    twins[firstHalf(h)] = secondHalf(mesh.twin(h));
    twins[secondHalf(h)] = firstHalf(mesh.twin(h));
  }
  return twins;
}

}  // namespace

void WorkingMesh::subdivide(std::span<const Placement> midpoints) {
  const Index faces = Index(mesh_.faceCapacity());
  const std::size_t oldVertices = mesh_.vertexCapacity();
  HalfedgeData<Index> middle(mesh_.halfedgeCapacity(), kNone);
  Index next = Index(oldVertices);
  for (Index i = 0; i < mesh_.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    if (mesh_.isEdge(h))
      middle[h] = next++;
    else
      middle[h] = middle[mesh_.twin(h)];
  }
  std::vector<Index> triangles;
  triangles.reserve(12 * std::size_t{faces});
  HalfedgeData<Index> curve;
  curve.reserve(12 * std::size_t{faces});
  for (Index f = 0; f < faces; ++f) {
    const auto [a, b, c] = mesh_.vertices(Face(f));
    const Halfedge h = mesh_.halfedge(Face(f));
    const std::array<Index, 3> m = {middle[h], middle[mesh_.next(h)], middle[mesh_.prev(h)]};
    const std::array<Index, 3> e = {curve_[h], curve_[mesh_.next(h)], curve_[mesh_.prev(h)]};
    triangles.insert(triangles.end(), {a.index, m[0], m[2], b.index, m[1], m[0], c.index, m[2],
                                       m[1], m[0], m[1], m[2]});
    curve.values().insert(curve.values().end(), {e[0], kNone, e[2], e[1], kNone, e[0], e[2], kNone,
                                                 e[1], kNone, kNone, kNone});
  }
  mesh_ = HalfedgeMesh(next, triangles, subdividedTwins(mesh_));
  curve_ = std::move(curve);
  grow();
  unsettleAll();
  for (std::size_t i = 0; i < midpoints.size(); ++i)
    place(Vertex(Index(oldVertices + i)), midpoints[i]);
}

void WorkingMesh::moveOnto(const OriginalSurface& surface, const VertexData<SurfacePoint>& points) {
  surface_ = &surface;
  for (Index i = 0; i < mesh_.vertexCapacity(); ++i) {
    const Vertex v(i);
    if (!mesh_.isAlive(v)) continue;
    if (kind_[v] == VertexKind::Interior)
      place(v, onSurface(points[v]));
    else if (kind_[v] == VertexKind::Curve)
      place(v, onCurve(on_[v]));
    else
      at_[v] = points[v];
  }
}

void WorkingMesh::compact() {
  const HalfedgeMesh::Renumbering map = mesh_.compact();
  for (Index v = 0; v < map.vertex.size(); ++v)
    if (map.vertex[v] != kNone) {
      place(Vertex(map.vertex[v]), placement(Vertex(v)));
      pinned_[Vertex(map.vertex[v])] = pinned_[Vertex(v)];
      unrest_[Vertex(map.vertex[v])] = unrest_[Vertex(v)];
    }
  for (Index h = 0; h < 3 * map.face.size(); ++h)
    if (map.face[h / 3] != kNone)
      curve_[Halfedge(3 * map.face[h / 3] + h % 3)] = curve_[Halfedge(h)];
  const std::size_t n = mesh_.vertexCapacity();
  position_.resize(n);
  normal_.resize(n);
  across_.resize(n);
  at_.resize(n);
  on_.resize(n);
  kind_.resize(n);
  pinned_.resize(n);
  unrest_.resize(n);
  curve_.resize(mesh_.halfedgeCapacity());
}

}  // namespace remesher
