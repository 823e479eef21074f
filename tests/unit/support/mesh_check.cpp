// SPDX-License-Identifier: MIT
#include "support/mesh_check.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace remesher {

namespace {

std::string at(const char* kind, Index index, const char* what) {
  return std::string(kind) + ' ' + std::to_string(index) + ' ' + what;
}

std::string checkFaces(const HalfedgeMesh& mesh) {
  std::size_t alive = 0;
  for (Index f = 0; f < mesh.faceCapacity(); ++f) {
    const auto [a, b, c] = mesh.vertices(Face(f));
    if (bool(a) != bool(b) || bool(b) != bool(c)) return at("face", f, "is half dead");
    if (!a) continue;
    ++alive;
    for (const Vertex v : {a, b, c}) {
      if (v.index >= mesh.vertexCapacity()) return at("face", f, "names a vertex out of range");
      if (!mesh.isAlive(v)) return at("face", f, "has a dead vertex");
    }
    if (a == b || b == c || c == a) return at("face", f, "has a vertex twice");
  }
  if (alive != mesh.faceCount()) return "faceCount() is not the number of living faces";
  return {};
}

std::string checkTwins(const HalfedgeMesh& mesh) {
  for (Index i = 0; i < mesh.halfedgeCapacity(); ++i) {
    const Halfedge h(i), t = mesh.twin(h);
    if (!mesh.isAlive(h)) {
      if (t) return at("halfedge", i, "is dead and has a twin");
      continue;
    }
    if (!t) continue;
    if (t.index >= mesh.halfedgeCapacity() || !mesh.isAlive(t))
      return at("halfedge", i, "has a dead twin");
    if (mesh.twin(t) != h) return at("halfedge", i, "is not its twin's twin");
    if (mesh.origin(t) != mesh.tip(h) || mesh.tip(t) != mesh.origin(h))
      return at("halfedge", i, "does not run opposite to its twin");
  }
  return {};
}

std::string checkEdges(const HalfedgeMesh& mesh) {
  std::vector<std::pair<Vertex, Vertex>> ends;
  for (Index i = 0; i < mesh.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    if (mesh.isEdge(h)) ends.emplace_back(std::minmax(mesh.origin(h), mesh.tip(h)));
  }
  std::sort(ends.begin(), ends.end());
  const auto twice = std::adjacent_find(ends.begin(), ends.end());
  if (twice == ends.end()) return {};
  return "two edges join vertices " + std::to_string(twice->first.index) + " and " +
         std::to_string(twice->second.index);
}

// The halfedges that leave a vertex, found without turning around it.
struct Leaving {
  Index halfedges = 0;
  bool boundary = false;
};

std::vector<Leaving> countLeaving(const HalfedgeMesh& mesh) {
  std::vector<Leaving> result(mesh.vertexCapacity());
  for (Index i = 0; i < mesh.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    if (!mesh.isAlive(h)) continue;
    Leaving& leaving = result[mesh.origin(h).index];
    ++leaving.halfedges;
    leaving.boundary = leaving.boundary || mesh.isBoundary(h);
  }
  return result;
}

std::string checkVertices(const HalfedgeMesh& mesh) {
  const std::vector<Leaving> leaving = countLeaving(mesh);
  std::size_t alive = 0;
  for (Index i = 0; i < mesh.vertexCapacity(); ++i) {
    const Vertex v(i);
    if (!mesh.isAlive(v)) continue;
    ++alive;
    const Halfedge first = mesh.outgoing(v);
    if (first.index >= mesh.halfedgeCapacity() || mesh.origin(first) != v)
      return at("vertex", i, "has an outgoing halfedge that leaves another");
    if (leaving[i].boundary && !mesh.isBoundary(v))
      return at("vertex", i, "lies on a boundary that its outgoing halfedge does not follow");
    Index turned = 0;
    mesh.forEachOutgoing(v, [&](Halfedge) { ++turned; });
    if (turned != leaving[i].halfedges)
      return at("vertex", i, "has faces that a turn around it misses");
  }
  if (alive != mesh.vertexCount()) return "vertexCount() is not the number of living vertices";
  return {};
}

}  // namespace

std::string check(const HalfedgeMesh& mesh) {
  for (const auto law : {checkFaces, checkTwins, checkEdges, checkVertices})
    if (std::string broken = law(mesh); !broken.empty()) return broken;
  return {};
}

}  // namespace remesher
