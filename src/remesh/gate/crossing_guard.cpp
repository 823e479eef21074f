// SPDX-License-Identifier: MIT
#include "remesh/gate/crossing_guard.h"

#include <algorithm>
#include <cmath>

#include "geometry/predicates.h"

namespace remesher {

namespace {

Box boxAround(const NamedTriangle& t) {
  Box box;
  for (const Vec3& p : t.at) box.extend(p);
  return box;
}

double meanEdge(const WorkingMesh& mesh) {
  double sum = 0;
  std::size_t count = 0;
  const HalfedgeMesh& m = mesh.mesh();
  for (Index i = 0; i < m.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    if (!m.isEdge(h)) continue;
    sum += mesh.edgeLength(h);
    ++count;
  }
  return sum > 0 ? sum / double(count) : 1;
}

bool contains(std::span<const Face> faces, Face f) {
  return std::find(faces.begin(), faces.end(), f) != faces.end();
}

// The index by which the triangles around know the moved vertex; kNone for a new one.
Index nameOfMoved(const HalfedgeMesh& mesh, const LocalChange& change) {
  if (change.operation == Operation::Collapse) return mesh.tip(change.halfedge).index;
  return change.operation == Operation::Relocate ? change.vertex.index : kNone;
}

// Whether a triangle's last corner passes the triangle that stays at the other two on its way to q.
bool passes(const Triangle& stays, const Triangle& moves, const Vec3& q) {
  const auto& [a, b, p] = moves;
  const auto& [c, d, e] = stays;
  const int begin = orient3d(c, d, e, p), end = orient3d(c, d, e, q);
  return begin * end < 0 && begin * orient3d(a, b, p, q) > 0;
}

}  // namespace

CrossingGuard::CrossingGuard(const WorkingMesh& mesh, const Quantum& quantum)
    : mesh_(mesh), quantum_(quantum), grid_(0, 0) {
  enterAll();
}

void CrossingGuard::enterAll() {
  added_ = 0;
  grid_ = TriangleGrid(meanEdge(mesh_), mesh_.mesh().faceCount());
  for (Index i = 0; i < mesh_.mesh().faceCapacity(); ++i)
    if (mesh_.mesh().isAlive(Face(i))) grid_.add(i, boxAround(present(Face(i))));
}

NamedTriangle CrossingGuard::present(Face f) const {
  const auto v = mesh_.mesh().vertices(f);
  NamedTriangle t;
  for (std::size_t k = 0; k < 3; ++k) {
    t.vertices[k] = v[k].index;
    t.at[k] = written(mesh_.position(v[k]), quantum_);
  }
  return t;
}

NamedTriangle CrossingGuard::coming(const LocalChange& change,
                                    const std::array<Vertex, 3>& corners) const {
  NamedTriangle t;
  for (std::size_t k = 0; k < 3; ++k) {
    t.vertices[k] = corners[k] == kMoved ? nameOfMoved(mesh_.mesh(), change) : corners[k].index;
    t.at[k] = written(positionAfter(mesh_, change, corners[k]), quantum_);
  }
  return t;
}

// The triangle must have an area.
template <class Visit>
void CrossingGuard::forEachMet(const NamedTriangle& t, std::span<const Face> leftOut,
                               Visit visit) const {
  grid_.visit(boxAround(t), [&](Index name) {
    if (!mesh_.mesh().isAlive(Face(name)) || contains(leftOut, Face(name))) return;
    const NamedTriangle other = present(Face(name));
    if (trianglesMeet(t, other) && hasArea(other.at)) visit(Face(name));
  });
}

std::size_t CrossingGuard::countAround(const NamedTriangle& t,
                                       std::span<const Face> leftOut) const {
  if (!hasArea(t.at)) return 1;
  std::size_t pairs = 0;
  forEachMet(t, leftOut, [&](Face) { ++pairs; });
  return pairs;
}

std::size_t CrossingGuard::countAmong(std::span<const NamedTriangle> triangles,
                                      std::span<const Face> leftOut, std::size_t enough) const {
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < triangles.size() && pairs < enough; ++i) {
    pairs += countAround(triangles[i], leftOut);
    for (std::size_t k = 0; k < i; ++k)
      if (hasArea(triangles[i].at) && hasArea(triangles[k].at))
        pairs += trianglesMeet(triangles[i], triangles[k]);
  }
  return pairs;
}

// Whether a triangle turns past a neighbour that stays. The two meet neither before nor after, but
// change sides: a thin body would be inside out.
bool CrossingGuard::turnsPast(std::span<const NamedTriangle> after,
                              std::span<const Face> gone) const {
  for (const Face f : gone) {
    const NamedTriangle before = present(f);
    for (std::size_t k = 0; k < 3; ++k) {
      const Halfedge twin = mesh_.mesh().twin(HalfedgeMesh::halfedge(f, int(k)));
      if (!twin || contains(gone, HalfedgeMesh::face(twin))) continue;
      const Triangle stays = present(HalfedgeMesh::face(twin)).at;
      const std::size_t next = (k + 1) % 3;
      const Triangle moves = {before.at[k], before.at[next], before.at[(k + 2) % 3]};
      for (const NamedTriangle& t : after)
        for (std::size_t i = 0; i < 3; ++i)
          if (t.vertices[i] == before.vertices[k] &&
              t.vertices[(i + 1) % 3] == before.vertices[next] &&
              passes(stays, moves, t.at[(i + 2) % 3]))
            return true;
    }
  }
  return false;
}

bool CrossingGuard::allows(const LocalChange& change) const {
  std::vector<NamedTriangle> after;
  for (const auto& corners : change.coming) after.push_back(coming(change, corners));
  const std::vector<Face> gone = removedFaces(mesh_.mesh(), change);
  if (turnsPast(after, gone)) return false;
  return countAmong(after, gone, 1) == 0 || growth(change) <= 0;
}

std::ptrdiff_t CrossingGuard::growth(const LocalChange& change) const {
  std::vector<NamedTriangle> before, after;
  const std::vector<Face> gone = removedFaces(mesh_.mesh(), change);
  for (const Face f : gone) before.push_back(present(f));
  for (const auto& corners : change.coming) after.push_back(coming(change, corners));
  const std::size_t pairs = countAmong(before, gone, before.max_size());
  return std::ptrdiff_t(countAmong(after, gone, pairs + 1)) - std::ptrdiff_t(pairs);
}

void CrossingGuard::update(const LocalChange& change, Vertex result) {
  const HalfedgeMesh& mesh = mesh_.mesh();
  // Entries of triangles that moved or are gone cost looks, so that they are cleared away in time.
  if (added_ > 2 * mesh.faceCount()) enterAll();
  const auto add = [&](Face f) {
    grid_.add(f.index, boxAround(present(f)));
    ++added_;
  };
  for (const Face f : change.going)
    if (mesh.isAlive(f)) add(f);
  if (result) mesh.forEachOutgoing(result, [&](Halfedge h) { add(HalfedgeMesh::face(h)); });
}

std::vector<Face> CrossingGuard::metBy(Face f) const {
  const NamedTriangle t = present(f);
  if (!hasArea(t.at)) return {f};
  std::vector<Face> met;
  forEachMet(t, std::span(&f, 1), [&](Face other) { met.push_back(other); });
  return met;
}

std::vector<Face> CrossingGuard::crossing() const {
  std::vector<Face> result;
  for (Index i = 0; i < mesh_.mesh().faceCapacity(); ++i)
    if (mesh_.mesh().isAlive(Face(i)) && !metBy(Face(i)).empty()) result.push_back(Face(i));
  return result;
}

}  // namespace remesher
