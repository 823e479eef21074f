// SPDX-License-Identifier: MIT
#include "remesh/conforming/faceted_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "geometry/predicates.h"
#include "geometry/triangle.h"
#include "mesh/joints.h"
#include "original/curves/facets.h"
#include "original/curves/shape_angles.h"
#include "remesh/conforming/line_corners.h"

namespace remesher {

namespace {

// A point this near to a corner or an edge of its triangle, in weights, is on it.
constexpr double kOnIt = 1e-12;

}  // namespace

FacetedMesh::FacetedMesh(const BuiltMesh& original, const HalfedgeData<char>& seams)
    : original_(original),
      mesh_(original.mesh),
      positions_(original.positions),
      at_(mesh_.vertexCapacity()),
      role_(mesh_.vertexCapacity(), FacetRole::Free),
      source_(mesh_.vertexCapacity()),
      along_(mesh_.vertexCapacity()),
      line_(mesh_.halfedgeCapacity(), kNone) {
  setFacets(seams);
  setFrames();
  setRoles(seams);
}

// Seams divide a plane into several facets.
void FacetedMesh::setFacets(const HalfedgeData<char>& seams) {
  const FaceData<Index> planes = findFacets(mesh_, positions_, flatTolerance(mesh_, positions_));
  ownFacet_.assign(mesh_.faceCapacity(), kNone);
  std::vector<Face> stack;
  for (Index i = 0; i < mesh_.faceCapacity(); ++i) {
    if (!mesh_.isAlive(Face(i)) || ownFacet_[Face(i)] != kNone) continue;
    const Index facet = Index(faces_.size());
    faces_.emplace_back();
    ownFacet_[Face(i)] = facet;
    stack.push_back(Face(i));
    while (!stack.empty()) {
      const Face f = stack.back();
      stack.pop_back();
      faces_.back().push_back(f);
      for (int k = 0; k < 3; ++k) {
        const Halfedge h = HalfedgeMesh::halfedge(f, k), t = mesh_.twin(h);
        if (!t || seams[h] || ownFacet_[mesh_.face(t)] != kNone) continue;
        if (planes[mesh_.face(t)] != planes[f]) continue;
        ownFacet_[mesh_.face(t)] = facet;
        stack.push_back(mesh_.face(t));
      }
    }
  }
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

// Makes room for what an operator has added.
void FacetedMesh::grow() {
  const std::size_t vertices = mesh_.vertexCapacity();
  positions_.resize(vertices, Vec3::Zero());
  at_.resize(vertices);
  role_.resize(vertices, FacetRole::Free);
  source_.resize(vertices);
  along_.resize(vertices);
  facet_.resize(mesh_.faceCapacity(), kNone);
  line_.resize(mesh_.halfedgeCapacity(), kNone);
}

void FacetedMesh::put(Vertex v, FacetRole role, const Place& place) {
  role_[v] = role;
  at_[v] = place.at;
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

Vertex FacetedMesh::divide(Face f, const Vec2& place) {
  const Index facet = facet_[f];
  const Place found = placeAt(place, facet, pointIn(mesh_.vertices(f)[0], facet).face);
  const Vec2 p = frames_[facet].flat(found.position);
  for (int k = 0; k < 3; ++k) {
    const Halfedge h = HalfedgeMesh::halfedge(f, k);
    // Not so either where the place is no number.
    if (!(orient2d(flat(mesh_.origin(h), facet), flat(mesh_.tip(h), facet), p) > 0)) return {};
  }
  Halfedge h = HalfedgeMesh::halfedge(f);
  for (int k = 0; k < 3 && !mesh_.twin(h); ++k) h = mesh_.next(h);
  if (!mesh_.twin(h)) return {};
  const Vertex v = splitOff(h);
  put(v, FacetRole::Free, found);
  return v;
}

double FacetedMesh::arcOf(Vertex v, Index chain) const {
  return role_[v] == FacetRole::Corner ? curves_.atCorner(chain, source_[v]).arc : along_[v].arc;
}

Vertex FacetedMesh::split(Halfedge h, double share) {
  const Index chain = line_[h];
  const double from = arcOf(mesh_.origin(h), chain), to = arcOf(mesh_.tip(h), chain);
  const CurvePoint along{chain, from + share * (to - from)};
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

// The same point in a triangle of the facet that has the same corner or edge, if any has.
std::optional<SurfacePoint> FacetedMesh::across(const SurfacePoint& point, Index facet) const {
  const HalfedgeMesh& m = original_.mesh;
  Eigen::Index largest = 0, least = 0;
  if (point.barycentric.maxCoeff(&largest) >= 1 - kOnIt) {
    std::optional<SurfacePoint> found;
    m.forEachOutgoing(m.vertices(point.face)[std::size_t(largest)], [&](Halfedge h) {
      if (!found && ownFacet_[m.face(h)] == facet)
        found = {m.face(h), Vec3::Unit(Eigen::Index(h.index % 3))};
    });
    return found;
  }
  if (point.barycentric.minCoeff(&least) > kOnIt) return {};
  const Halfedge h = HalfedgeMesh::halfedge(point.face, int((least + 1) % 3)), t = m.twin(h);
  if (!t || ownFacet_[m.face(t)] != facet) return {};
  SurfacePoint result{m.face(t), Vec3::Zero()};
  result.barycentric[Eigen::Index(t.index % 3)] = point.barycentric[(least + 2) % 3];
  result.barycentric[Eigen::Index(m.next(t).index % 3)] = point.barycentric[(least + 1) % 3];
  return result;
}

// Of a place without numbers, beside a triangle that is hardly more than a line, a corner.
SurfacePoint FacetedMesh::nearestIn(Index facet, const Vec3& p) const {
  SurfacePoint best{faces_[facet].front(), Vec3::Unit(0)};
  double least = kInfinity;
  for (const Face f : faces_[facet]) {
    const auto [a, b, c] = original_.mesh.vertices(f);
    const auto& at = original_.positions;
    const Vec3 weights = closestBarycentric(p, at[a], at[b], at[c]);
    const Vec3 found = weights[0] * at[a] + weights[1] * at[b] + weights[2] * at[c];
    const double squared = (found - p).squaredNorm();
    if (squared < least) least = squared, best = {f, weights};
  }
  return best;
}

SurfacePoint FacetedMesh::pointIn(Vertex v, Index facet) const {
  if (ownFacet_[at_[v].face] == facet) return at_[v];
  const std::optional<SurfacePoint> found = across(at_[v], facet);
  return found ? *found : nearestIn(facet, positions_[v]);
}

// Walks from triangle to triangle towards the place; where a walk ends at the rim of the facet, all
// triangles are looked at.
FacetedMesh::Place FacetedMesh::placeAt(const Vec2& place, Index facet, Face start) const {
  const HalfedgeMesh& m = original_.mesh;
  const auto at = [&](Vertex v) { return frames_[facet].flat(original_.positions[v]); };
  Face f = start, end = start;
  std::size_t steps = 0;
  for (; f && steps <= faces_[facet].size(); ++steps) {
    end = f;
    Halfedge out;
    for (std::size_t k = 0; k < 3 && !out; ++k) {
      const Halfedge h = HalfedgeMesh::halfedge(f, int((k + steps) % 3));
      if (orient2d(at(m.origin(h)), at(m.tip(h)), place) < 0) out = h;
    }
    if (!out) break;
    const Halfedge t = m.twin(out);
    f = t && ownFacet_[m.face(t)] == facet ? m.face(t) : Face();
  }
  const Vec3 p = frames_[facet].lifted(place);
  SurfacePoint found;
  if (f && steps <= faces_[facet].size()) {
    const auto [a, b, c] = m.vertices(end);
    found = {end, closestBarycentric(p, original_.positions[a], original_.positions[b],
                                     original_.positions[c])};
  } else {
    found = nearestIn(facet, p);
  }
  // By differences, so that a coordinate that all three corners have stays as it is.
  const auto [a, b, c] = m.vertices(found.face);
  const Vec3& first = original_.positions[a];
  return {found, first + found.barycentric[1] * (original_.positions[b] - first) +
                     found.barycentric[2] * (original_.positions[c] - first)};
}

}  // namespace remesher
