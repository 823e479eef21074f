// SPDX-License-Identifier: MIT
#include "remesh/steps/coarsen.h"

#include <array>

#include "base/fires.h"
#include "base/patience.h"
#include "mesh/star_passes.h"
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
      : run_(run), goal_(goal), progress_(progress), passes_(run.mesh.mesh()) {}

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
  bool isTooMany() const { return run_.mesh.mesh().vertexCount() > goal_.vertices; }

  // The shortest first.
  EdgeQueue worthATry() const {
    VertexSizes sizes(run_);
    return {run_.mesh.mesh(), [&](Halfedge h) { return passes_.isTouched(h); },
            [&](Halfedge h) { return -sizes.relativeLength(h); }};
  }

  std::size_t pass() {
    EdgeQueue edges = worthATry();
    const std::size_t count = edges.size();
    const auto goesOn = [&] {
      if (!isTooMany() || areProofsSpent(run_)) return false;
      const std::size_t i = count - edges.size();
      if (i % kTick == 0) progress_.at(1 - left_ + kPassShare * left_ * double(i) / double(count));
      return true;
    };
    const std::size_t collapses = passes_.run(edges, goesOn, [&](Halfedge h) {
      return !passes_.isTouched(h) && collapse(h) ? run_.scratch.result : Vertex();
    });
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
  StarPasses passes_;
};

}  // namespace

void coarsen(Run& run, std::size_t vertices, MeetingPlace place, const Progress& progress) {
  Coarsening(run, {vertices, place}, progress).run();
}

}  // namespace remesher
