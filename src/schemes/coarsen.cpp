// SPDX-License-Identifier: MIT
#include "schemes/coarsen.h"

#include <algorithm>
#include <vector>

#include "schemes/lengths.h"

namespace remesher {

namespace {

class Coarsening {
 public:
  Coarsening(Run& run, std::size_t vertices)
      : run_(run), vertices_(vertices), changed_(run.mesh.mesh().vertexCapacity(), 1) {}

  void run() {
    while (isTooMany() && pass() > 0) {
    }
  }

 private:
  struct Ranked {
    double length;
    Halfedge edge;
  };

  bool isTooMany() const { return run_.mesh.mesh().vertexCount() > vertices_; }

  std::vector<Ranked> worthATry() const {
    const HalfedgeMesh& mesh = run_.mesh.mesh();
    std::vector<Ranked> edges;
    for (Index i = 0; i < mesh.halfedgeCapacity(); ++i) {
      const Halfedge h(i);
      if (!mesh.isEdge(h) || !(changed_[mesh.origin(h)] || changed_[mesh.tip(h)])) continue;
      edges.push_back({relativeLength(run_, h), h});
    }
    std::stable_sort(edges.begin(), edges.end(),
                     [](const Ranked& a, const Ranked& b) { return a.length < b.length; });
    return edges;
  }

  std::size_t pass() {
    const HalfedgeMesh& mesh = run_.mesh.mesh();
    const std::vector<Ranked> edges = worthATry();
    changed_.assign(mesh.vertexCapacity(), 0);
    std::size_t collapses = 0;
    for (const auto& [length, h] : edges) {
      if (!isTooMany()) break;
      if (!mesh.isAlive(h) || changed_[mesh.origin(h)] || changed_[mesh.tip(h)]) continue;
      if (!collapse(h)) continue;
      ++collapses;
      changed_[run_.result] = 1;
      mesh.forEachNeighbor(run_.result, [&](Vertex w) { changed_[w] = 1; });
    }
    return collapses;
  }

  // In the middle, else into one of the ends.
  bool collapse(Halfedge h) {
    if (proposeCollapse(run_.mesh, run_.projector, h, run_.change) && commit(run_)) return true;
    for (const Halfedge into : {h, run_.mesh.mesh().twin(h)})
      if (into && proposeCollapseInto(run_.mesh, into, run_.change) && commit(run_)) return true;
    return false;
  }

  Run& run_;
  std::size_t vertices_;
  VertexData<char> changed_;
};

}  // namespace

void coarsen(Run& run, std::size_t vertices) { Coarsening(run, vertices).run(); }

}  // namespace remesher
