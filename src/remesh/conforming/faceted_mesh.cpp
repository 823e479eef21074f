// SPDX-License-Identifier: MIT
#include "remesh/conforming/faceted_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "geometry/predicates.h"
#include "geometry/triangle.h"
#include "mesh/components.h"
#include "mesh/joints.h"
#include "original/curves/facets.h"
#include "original/curves/shape_angles.h"
#include "remesh/conforming/line_corners.h"

namespace remesher {

namespace {

// By how many times what is flat may be off the places of a vertex may differ that two facets
// have, unrolled.
constexpr double kUnrolledTolerance = 4;

}  // namespace

FacetedMesh::FacetedMesh(const BuiltMesh& original, const HalfedgeData<char>& seams,
                         const FacetLimits& limits)
    : original_(original),
      limits_(limits),
      mesh_(original.mesh),
      positions_(original.positions),
      at_(mesh_.vertexCapacity()),
      known_(mesh_.vertexCapacity()),
      role_(mesh_.vertexCapacity(), FacetRole::Free),
      source_(mesh_.vertexCapacity()),
      along_(mesh_.vertexCapacity()),
      line_(mesh_.halfedgeCapacity(), kNone) {
  setFacets(seams);
  unroll(seams);
  setFrames();
  setRoles(seams);
}

// Seams divide a plane into several facets.
void FacetedMesh::setFacets(const HalfedgeData<char>& seams) {
  const FaceData<Index> planes = findFacets(mesh_, positions_, flatTolerance(mesh_, positions_));
  ownFacet_ = regionsOf(mesh_, [&](Halfedge h) {
                const Halfedge t = mesh_.twin(h);
                return !seams[h] && planes[HalfedgeMesh::face(t)] == planes[HalfedgeMesh::face(h)];
              }).of;
}

// The planes become regions of one or several, each with its faces.
void FacetedMesh::unroll(const HalfedgeData<char>& seams) {
  HalfedgeData<char> fixed = seams;
  for (const Halfedge h : findJoints(original_)) {
    fixed[h] = 1;
    if (mesh_.twin(h)) fixed[mesh_.twin(h)] = 1;
  }
  const double tolerance = kUnrolledTolerance * flatTolerance(mesh_, positions_);
  unrolled_ = unrollFacets(mesh_, positions_, ownFacet_, fixed, depth(), tolerance);
  ownFacet_ = unrolled_.regionOf;
  faces_.assign(unrolled_.isBent.size(), {});
  for (Index i = 0; i < mesh_.faceCapacity(); ++i)
    if (mesh_.isAlive(Face(i))) faces_[ownFacet_[Face(i)]].emplace_back(i);
  facet_ = ownFacet_;
}

void FacetedMesh::setFrames() {
  for (const std::vector<Face>& faces : faces_) {
    Vec3 normal = Vec3::Zero();
    for (const Face f : faces) {
      const auto [a, b, c] = mesh_.vertices(f);
      normal += areaVector(positions_[a], positions_[b], positions_[c]);
    }
    normal.normalize();
    const Vec3 u = normal.unitOrthogonal();
    frames_.push_back({positions_[mesh_.vertices(faces.front())[0]], u, normal.cross(u)});
  }
}

void FacetedMesh::setRoles(const HalfedgeData<char>& seams) {
  HalfedgeData<char> lines(mesh_.halfedgeCapacity(), 0);
  CurveRules rules;
  for (Index i = 0; i < mesh_.halfedgeCapacity(); ++i) {
    const Halfedge h(i), t = mesh_.isAlive(h) ? mesh_.twin(h) : Halfedge();
    if (!t || !(seams[h] || facet_[mesh_.face(h)] != facet_[mesh_.face(t)])) continue;
    lines[h] = 1;
    if (mesh_.isEdge(h)) rules.edges.push_back(h);
  }
  rules.kept = findJoints(original_);
  for (const Halfedge h : rules.kept) {
    lines[h] = 1;
    if (mesh_.twin(h)) lines[mesh_.twin(h)] = 1;
  }
  rules.corners = cornersOfLines(mesh_, positions_, lines, flatTolerance(mesh_, positions_));
  curves_ = FeatureCurves(mesh_, positions_, rules);
  for (Index i = 0; i < mesh_.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    if (!mesh_.isAlive(h)) continue;
    line_[h] = curves_.chain(h);
    at_[mesh_.origin(h)] = {HalfedgeMesh::face(h), Vec3::Unit(Eigen::Index(h.index % 3))};
  }
  for (Index i = 0; i < curves_.chains().size(); ++i) {
    const Chain& chain = curves_.chains()[i];
    for (std::size_t k = 0; k < chain.vertices.size(); ++k) {
      const Vertex v = chain.vertices[k];
      role_[v] = FacetRole::OnLine;
      along_[v] = {i, chain.arcs[k]};
    }
  }
  for (Index i = 0; i < mesh_.vertexCapacity(); ++i) {
    if (!curves_.isCorner(Vertex(i))) continue;
    role_[Vertex(i)] = FacetRole::Corner;
    source_[Vertex(i)] = Vertex(i);
  }
}

bool FacetedMesh::hasOpenSeam() const {
  for (Index i = 0; i < mesh_.halfedgeCapacity(); ++i) {
    const Halfedge h(i), t = mesh_.isAlive(h) ? mesh_.twin(h) : Halfedge();
    if (!t || !isLine(h) || isKept(h)) continue;
    if (facet_[mesh_.face(h)] == facet_[mesh_.face(t)]) return true;
  }
  return false;
}

bool FacetedMesh::isSound() const {
  for (Index i = 0; i < mesh_.faceCapacity(); ++i)
    if (mesh_.isAlive(Face(i)) && turn(Face(i)) <= 0) return false;
  return true;
}

int FacetedMesh::turn(Vertex a, Vertex b, Vertex c, Index facet) const {
  return orient2d(flat(a, facet), flat(b, facet), flat(c, facet));
}

int FacetedMesh::turn(Face f) const {
  const auto [a, b, c] = mesh_.vertices(f);
  return turn(a, b, c, facet_[f]);
}

bool FacetedMesh::canFlip(Halfedge h) const {
  if (isLine(h) || !EulerOperators::canFlip(mesh_, h)) return false;
  const Halfedge t = mesh_.twin(h);
  const Vertex a = mesh_.origin(h), b = mesh_.tip(h);
  const Vertex c = mesh_.opposite(h), d = mesh_.opposite(t);
  const Index facet = facet_[mesh_.face(h)];
  return turn(d, b, c, facet) > 0 && turn(c, a, d, facet) > 0;
}

void FacetedMesh::flip(Halfedge h) {
  const Halfedge t = mesh_.twin(h), ca = mesh_.prev(h), db = mesh_.prev(t);
  line_[h] = line_[db];
  line_[t] = line_[ca];
  line_[ca] = line_[db] = kNone;
  EulerOperators(mesh_).flip(h);
}

// Makes room for the elements that an operator has added.
void FacetedMesh::grow() {
  const std::size_t vertices = mesh_.vertexCapacity();
  positions_.resize(vertices, Vec3::Zero());
  at_.resize(vertices);
  known_.resize(vertices);
  role_.resize(vertices, FacetRole::Free);
  source_.resize(vertices);
  along_.resize(vertices);
  facet_.resize(mesh_.faceCapacity(), kNone);
  line_.resize(mesh_.halfedgeCapacity(), kNone);
}

void FacetedMesh::put(Vertex v, FacetRole role, const Place& place) {
  role_[v] = role;
  at_[v] = place.at;
  known_[v] = {};
  positions_[v] = place.position;
}

// A new vertex in the face of h, joined to its corners: on the edge first, which is then turned
// back to where it was.
Vertex FacetedMesh::splitOff(Halfedge h) {
  const Halfedge t = mesh_.twin(h);
  const Index facet = facet_[mesh_.face(h)], beyondFacet = facet_[mesh_.face(t)];
  const Index own = line_[h], bc = line_[mesh_.next(h)], ca = line_[mesh_.prev(h)];
  const Index ad = line_[mesh_.next(t)], db = line_[mesh_.prev(t)];
  EulerOperators operators(mesh_);
  const auto [v, beyond] = operators.split(h);
  grow();
  const Halfedge down = mesh_.next(mesh_.twin(beyond)), up = mesh_.twin(down);
  operators.flip(down);
  const auto set = [&](Halfedge first, const std::array<Index, 3>& lines, Index inFacet) {
    facet_[mesh_.face(first)] = inFacet;
    line_[first] = lines[0];
    line_[mesh_.next(first)] = lines[1];
    line_[mesh_.prev(first)] = lines[2];
  };
  set(h, {kNone, kNone, ca}, facet);
  set(beyond, {kNone, bc, kNone}, facet);
  set(up, {kNone, kNone, own}, facet);
  set(down, {ad, db, own}, beyondFacet);
  return v;
}

// A place exactly on an edge divides the triangles on both sides of it.
Vertex FacetedMesh::divide(Face f, const Vec2& place) {
  const Index facet = facet_[f];
  const Place found = placeAt(place, facet, pointIn(mesh_.vertices(f)[0], facet).face);
  const Vec2 p = isBent(facet) ? flatOf(found.at, facet) : frames_[facet].flat(found.position);
  Halfedge beside, below;
  for (int k = 0; k < 3; ++k) {
    const Halfedge h = HalfedgeMesh::halfedge(f, k);
    const int side = orient2d(flat(mesh_.origin(h), facet), flat(mesh_.tip(h), facet), p);
    if (side == 0 && !below && std::isfinite(p.sum())) below = h;
    // Not so either where the place is no number.
    else if (!(side > 0))
      return {};
    if (!beside && mesh_.twin(h)) beside = h;
  }
  if (below ? isLine(below) || !mesh_.twin(below) : !beside) return {};
  const Vertex v = below ? splitEdge(below) : splitOff(beside);
  put(v, FacetRole::Free, found);
  return v;
}

double FacetedMesh::arcOf(Vertex v, Index chain) const {
  return role_[v] == FacetRole::Corner ? curves_.atCorner(chain, source_[v]).arc : along_[v].arc;
}

// A new vertex on an edge, whose place is still to be set.
Vertex FacetedMesh::splitEdge(Halfedge h) {
  const Index chain = line_[h];
  const Halfedge t = mesh_.twin(h);
  const Index bc = line_[mesh_.next(h)], db = t ? line_[mesh_.prev(t)] : kNone;
  const auto [v, beyond] = EulerOperators(mesh_).split(h);
  grow();
  facet_[mesh_.face(beyond)] = facet_[mesh_.face(h)];
  line_[beyond] = chain;
  line_[mesh_.next(beyond)] = bc;
  line_[mesh_.next(h)] = line_[mesh_.prev(beyond)] = kNone;
  if (t) {
    const Halfedge back = mesh_.twin(beyond);
    facet_[mesh_.face(back)] = facet_[mesh_.face(t)];
    line_[back] = chain;
    line_[mesh_.prev(back)] = db;
    line_[mesh_.prev(t)] = line_[mesh_.next(back)] = kNone;
  }
  return v;
}

Vertex FacetedMesh::split(Halfedge h, double share) {
  const Index chain = line_[h];
  const double from = arcOf(mesh_.origin(h), chain), to = arcOf(mesh_.tip(h), chain);
  const CurvePoint along{chain, from + share * (to - from)};
  const Vertex v = splitEdge(h);
  const FeatureCurves::Place place = curves_.locate(original_.mesh, original_.positions, along);
  put(v, FacetRole::OnLine, {place.at, place.position});
  along_[v] = along;
  return v;
}

// Whether all triangles that stay at the origin of h would be counterclockwise with its tip.
bool FacetedMesh::staysTurned(Halfedge h) const {
  const Vertex to = mesh_.tip(h);
  const Face left = mesh_.face(h), right = mesh_.twin(h) ? mesh_.face(mesh_.twin(h)) : Face();
  bool stays = true;
  mesh_.forEachOutgoing(mesh_.origin(h), [&](Halfedge o) {
    const Face f = mesh_.face(o);
    if (f == left || f == right) return;
    stays = stays && turn(to, mesh_.tip(o), mesh_.opposite(o), facet_[f]) > 0;
  });
  return stays;
}

bool FacetedMesh::collapse(Halfedge h) {
  const Halfedge t = mesh_.twin(h);
  if ((role(mesh_.origin(h)) == FacetRole::OnLine) != isLine(h)) return false;
  // A triangle whose corners lie on one line: its third side would join two facets unseen.
  if (isLine(mesh_.prev(h)) || (t && isLine(mesh_.next(t)))) return false;
  if (!EulerOperators::canCollapse(mesh_, h) || !staysTurned(h)) return false;
  if (const Halfedge y = mesh_.twin(mesh_.prev(h))) line_[y] = line_[mesh_.next(h)];
  if (t)
    if (const Halfedge z = mesh_.twin(mesh_.next(t))) line_[z] = line_[mesh_.prev(t)];
  EulerOperators(mesh_).collapse(h);
  return true;
}

void FacetedMesh::move(Vertex v, const Vec2& place, Index facet) {
  put(v, FacetRole::Free, placeAt(place, facet, at_[v].face));
}

FacetedMesh::Reach FacetedMesh::reach(Vertex v) const {
  const CurvePoint own = along_[v];
  Reach reach{own.arc, own.arc, own.arc};
  mesh_.forEachNeighbor(v, [&](Vertex w) {
    const Halfedge out = mesh_.find(v, w), h = out ? out : mesh_.find(w, v);
    if (line_[h] != own.chain) return;
    const double arc = arcOf(w, own.chain);
    (arc < own.arc ? reach.from : reach.to) = arc;
  });
  return reach;
}

void FacetedMesh::slide(Vertex v, double arc) {
  along_[v].arc = arc;
  const FeatureCurves::Place place = curves_.locate(original_.mesh, original_.positions, along_[v]);
  put(v, FacetRole::OnLine, {place.at, place.position});
}

}  // namespace remesher
