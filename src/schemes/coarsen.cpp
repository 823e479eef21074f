// SPDX-License-Identifier: MIT
#include "schemes/coarsen.h"

#include <algorithm>
#include <array>
#include <vector>

#include "schemes/lengths.h"

namespace remesher {

namespace {

class Coarsening {
 public:
  Coarsening(Run& run, std::size_t vertices, MeetingPlace place)
      : run_(run),
        vertices_(vertices),
        place_(place),
        changed_(run.mesh.mesh().vertexCapacity(), 1) {}

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

  bool collapse(Halfedge h) {
    const std::array<Halfedge, 2> directions = {h, run_.mesh.mesh().twin(h)};
    for (const Halfedge d : directions)
      if (d && proposeCollapse(run_.mesh, run_.projector, d, run_.change) && commit(run_))
        return true;
    if (place_ == MeetingPlace::Middle) return false;
    for (const Halfedge d : directions)
      if (d && proposeCollapseInto(run_.mesh, d, run_.change) && commit(run_)) return true;
    return false;
  }

  Run& run_;
  std::size_t vertices_;
  MeetingPlace place_;
  VertexData<char> changed_;
};

}  // namespace

void coarsen(Run& run, std::size_t vertices, MeetingPlace place) {
  Coarsening(run, vertices, place).run();
}

}  // namespace remesher
