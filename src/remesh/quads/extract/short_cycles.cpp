// SPDX-License-Identifier: MIT
#include "remesh/quads/extract/short_cycles.h"

#include <algorithm>
#include <cstdint>

#include "mesh/shortest_paths.h"
#include "mesh/topology.h"

namespace remesher {

namespace {

// Per edge, by one bit each, which cycles of triangles cross it. A cycle of edges divides the
// surface if each cycle of triangles crosses it an even number of times.
using Crossings = HalfedgeData<std::uint64_t>;

// Cycles of triangles that all others are sums of: each edge that is in neither of two trees, of
// vertices and of triangles, closes one [Eppstein 2003].
class CrossingCycles {
 public:
  explicit CrossingCycles(const HalfedgeMesh& mesh)
      : mesh_(mesh),
        isTree_(mesh.halfedgeCapacity(), 0),
        entry_(mesh.faceCapacity()),
        crossings_(mesh.halfedgeCapacity(), 0) {}

  Crossings run() {
    growVertexTree();
    growFaceTree();
    int count = 0;
    for (Index i = 0; i < mesh_.halfedgeCapacity() && count < 64; ++i) {
      const Halfedge h(i), twin = mesh_.twin(h);
      if (!twin || twin < h || isTree_[h]) continue;
      const std::uint64_t bit = std::uint64_t{1} << count++;
      crossings_[h] ^= bit;
      crossings_[twin] ^= bit;
      markWay(HalfedgeMesh::face(h), bit);
      markWay(HalfedgeMesh::face(twin), bit);
    }
    return std::move(crossings_);
  }

 private:
  void take(Halfedge h) {
    isTree_[h] = 1;
    if (const Halfedge twin = mesh_.twin(h)) isTree_[twin] = 1;
  }

  // A boundary loop counts as one vertex, which all of its vertices are reached with: a way through
  // the inside from boundary to boundary would part the triangles, and keep their tree from some.
  void growVertexTree() {
    VertexData<char> seen(mesh_.vertexCapacity(), 0);
    std::vector<Vertex> queue;
    const auto reach = [&](Vertex v) {
      if (seen[v]) return false;
      for (; !seen[v]; v = mesh_.tip(mesh_.outgoing(v))) {
        seen[v] = 1;
        queue.push_back(v);
        if (!mesh_.isBoundary(v)) break;
      }
      return true;
    };
    reach(Vertex(0));
    for (std::size_t i = 0; i < queue.size(); ++i)
      mesh_.forEachOutgoing(queue[i], [&](Halfedge h) {
        if (reach(mesh_.tip(h))) take(h);
        if (reach(mesh_.origin(HalfedgeMesh::prev(h)))) take(HalfedgeMesh::prev(h));
      });
  }

  void growFaceTree() {
    FaceData<char> seen(mesh_.faceCapacity(), 0);
    std::vector<Face> queue = {Face(0)};
    seen[Face(0)] = 1;
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (int corner = 0; corner < 3; ++corner) {
        const Halfedge twin = mesh_.twin(HalfedgeMesh::halfedge(queue[i], corner));
        if (!twin || isTree_[twin] || seen[HalfedgeMesh::face(twin)]) continue;
        seen[HalfedgeMesh::face(twin)] = 1;
        take(twin);
        entry_[HalfedgeMesh::face(twin)] = twin;
        queue.push_back(HalfedgeMesh::face(twin));
      }
  }

  // Across the edges from a triangle back to the first one.
  void markWay(Face f, std::uint64_t bit) {
    while (const Halfedge h = entry_[f]) {
      crossings_[h] ^= bit;
      crossings_[mesh_.twin(h)] ^= bit;
      f = HalfedgeMesh::face(mesh_.twin(h));
    }
  }

  const HalfedgeMesh& mesh_;
  HalfedgeData<char> isTree_;  // of either tree
  FaceData<Halfedge> entry_;   // of a triangle: the edge by which the tree reached it
  Crossings crossings_;
};

// Grows trees of shortest ways, one vertex after the other, and looks for edges that close them.
class CycleSearch {
 public:
  CycleSearch(const WorkingMesh& mesh, double most)
      : mesh_(mesh),
        crossings_(CrossingCycles(mesh.mesh()).run()),
        most_(most),
        paths_(mesh.mesh().vertexCapacity()),
        crossed_(mesh.mesh().vertexCapacity()),
        by_(mesh.mesh().vertexCapacity()) {}

  // A cycle that divides nothing has an edge that a cycle of triangles crosses: a vertex of each
  // such edge will do.
  std::vector<Halfedge> run() {
    const HalfedgeMesh& m = mesh_.mesh();
    VertexData<char> isStart(m.vertexCapacity(), 0);
    for (Index i = 0; i < m.halfedgeCapacity(); ++i) {
      const Halfedge h(i);
      if (crossings_[h] == 0 || isStart[m.origin(h)] || isStart[m.tip(h)]) continue;
      if (mesh_.kind(m.origin(h)) != VertexKind::Interior) continue;
      isStart[m.origin(h)] = 1;
      searchFrom(m.origin(h));
    }
    return best_;
  }

 private:
  void searchFrom(Vertex start) {
    paths_.clear();
    paths_.reach(start, 0);
    crossed_[start] = 0;
    by_[start] = {};
    for (Vertex v; (v = paths_.leave());)
      mesh_.mesh().forEachOutgoing(v, [&](Halfedge h) {
        const Vertex w = mesh_.mesh().tip(h);
        if (mesh_.kind(w) != VertexKind::Interior) return;
        const double distance = paths_[v] + mesh_.edgeLength(h);
        const std::uint64_t crossed = crossed_[v] ^ crossings_[h];
        const bool closes = paths_[w] < kInfinity && crossed_[w] != crossed;
        if (closes && paths_[w] + distance < most_) keep(h);
        if (2 * distance >= most_ || !paths_.reach(w, distance)) return;
        crossed_[w] = crossed;
        by_[w] = h;
      });
  }

  std::vector<Halfedge> wayTo(Vertex v) const {
    std::vector<Halfedge> way;
    for (Halfedge h = by_[v]; h; h = by_[mesh_.mesh().origin(h)]) way.push_back(h);
    return way;
  }

  // The way to h's start, h, and back from its end.
  void keep(Halfedge h) {
    const HalfedgeMesh& m = mesh_.mesh();
    most_ = paths_[m.origin(h)] + mesh_.edgeLength(h) + paths_[m.tip(h)];
    best_ = wayTo(m.origin(h));
    std::reverse(best_.begin(), best_.end());
    best_.push_back(h);
    for (const Halfedge back : wayTo(m.tip(h))) best_.push_back(m.twin(back));
  }

  const WorkingMesh& mesh_;
  const Crossings crossings_;
  double most_;
  ShortestPaths paths_;
  VertexData<std::uint64_t> crossed_;  // by the shortest path to the vertex
  VertexData<Halfedge> by_;            // its last edge
  std::vector<Halfedge> best_;
};

}  // namespace

double lengthOf(const WorkingMesh& mesh, const std::vector<Halfedge>& edges) {
  double sum = 0;
  for (const Halfedge h : edges) sum += mesh.edgeLength(h);
  return sum;
}

std::vector<Halfedge> shortestCycle(const WorkingMesh& mesh, double most) {
  const HalfedgeMesh& m = mesh.mesh();
  if (eulerCharacteristic(m) + long(boundaryLoopCount(m)) == 2) return {};
  return CycleSearch(mesh, most).run();
}

}  // namespace remesher
