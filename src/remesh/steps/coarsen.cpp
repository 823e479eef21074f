// SPDX-License-Identifier: MIT
#include "remesh/steps/coarsen.h"

#include <algorithm>
#include <array>
#include <functional>
#include <vector>

#include "base/fires.h"
#include "base/patience.h"
#include "remesh/steps/lengths.h"

namespace remesher {

namespace {

constexpr std::size_t kTick = 1024;  // edges between two reports of progress
constexpr double kPassShare = 0.8;   // of the work that is left, about

class Coarsening {
 public:
  struct Goal {
    std::size_t vertices;
    MeetingPlace place;
  };

  Coarsening(Run& run, const Goal& goal, const Progress& progress)
      : run_(run),
        goal_(goal),
        progress_(progress),
        changed_(run.mesh.mesh().vertexCapacity(), 1) {}

  void run() {
    Patience patience;
    while (isTooMany()) {
      const std::size_t collapses = pass();
      if (!isTooMany()) return;
      if (areProofsSpent(run_)) return fires("coarsen: proofs spent");
      if (!patience.after(collapses, run_.mesh.mesh().vertexCount() - goal_.vertices))
        return fires("coarsen: collapses gain too little");
    }
  }

 private:
  struct Ranked {
    double length;
    Halfedge edge;

    bool operator>(const Ranked& other) const {
      return length > other.length || (length == other.length && other.edge < edge);
    }
  };

  bool isTooMany() const { return run_.mesh.mesh().vertexCount() > goal_.vertices; }

  // A heap, the shortest first: in most meshes few edges have to go.
  std::vector<Ranked> worthATry() const {
    const HalfedgeMesh& mesh = run_.mesh.mesh();
    VertexSizes sizes(run_);
    std::vector<Ranked> edges;
    for (Index i = 0; i < mesh.halfedgeCapacity(); ++i) {
      const Halfedge h(i);
      if (!mesh.isEdge(h) || !(changed_[mesh.origin(h)] || changed_[mesh.tip(h)])) continue;
      edges.push_back({sizes.relativeLength(h), h});
    }
    std::make_heap(edges.begin(), edges.end(), std::greater<>());
    return edges;
  }

  std::size_t pass() {
    const HalfedgeMesh& mesh = run_.mesh.mesh();
    std::vector<Ranked> edges = worthATry();
    const std::size_t count = edges.size();
    changed_.assign(mesh.vertexCapacity(), 0);
    std::size_t collapses = 0;
    for (; !edges.empty() && isTooMany() && !areProofsSpent(run_); edges.pop_back()) {
      const std::size_t i = count - edges.size();
      if (i % kTick == 0) progress_.at(1 - left_ + kPassShare * left_ * double(i) / double(count));
      std::pop_heap(edges.begin(), edges.end(), std::greater<>());
      const Halfedge h = edges.back().edge;
      if (!mesh.isAlive(h) || changed_[mesh.origin(h)] || changed_[mesh.tip(h)]) continue;
      if (!collapse(h)) continue;
      ++collapses;
      changed_[run_.scratch.result] = 1;
      mesh.forEachNeighbor(run_.scratch.result, [&](Vertex w) { changed_[w] = 1; });
    }
    left_ *= 1 - kPassShare;
    return collapses;
  }

  bool collapse(Halfedge h) {
    const std::array<Halfedge, 2> directions = {h, run_.mesh.mesh().twin(h)};
    for (const Halfedge d : directions)
      if (d && proposeCollapse(run_.mesh, run_.projector, d, run_.scratch.change) && commit(run_))
        return true;
    if (goal_.place == MeetingPlace::Middle) return false;
    for (const Halfedge d : directions)
      if (d && proposeCollapseInto(run_.mesh, d, run_.scratch.change) && commit(run_)) return true;
    return false;
  }

  Run& run_;
  Goal goal_;
  Progress progress_;
  double left_ = 1;  // of the work, as far as can be told
  VertexData<char> changed_;
};

}  // namespace

void coarsen(Run& run, std::size_t vertices, MeetingPlace place, const Progress& progress) {
  Coarsening(run, {vertices, place}, progress).run();
}

}  // namespace remesher
