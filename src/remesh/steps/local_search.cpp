// SPDX-License-Identifier: MIT
#include "remesh/steps/local_search.h"

#include <array>

namespace remesher {

void LocalSearch::offer() {
  const double gain = objective_(best_.gain);
  if (gain <= best_.gain) return;
  best_.gain = gain;
  best_.change = run_.scratch.change;
}

// No place gives a hub's triangles good angles, and each try costs a look at all of them.
bool LocalSearch::isAtHub(Halfedge h) const {
  const HalfedgeMesh& mesh = run_.mesh.mesh();
  return hubs_ && (hubs_->contains(mesh.origin(h)) || hubs_->contains(mesh.tip(h)));
}

bool LocalSearch::propose(Halfedge h, EdgeMove move) {
  LocalChange& change = run_.scratch.change;
  switch (move) {
    case EdgeMove::Flip:
      return proposeFlip(run_.mesh, h, change);
    case EdgeMove::Split:
      return proposeSplit(run_.mesh, run_.projector, h, change);
    case EdgeMove::Collapse:
      return proposeCollapse(run_.mesh, run_.projector, h, change);
    case EdgeMove::CollapseInto:
      return proposeCollapseInto(run_.mesh, h, change);
    case EdgeMove::Unite:
      return proposeUnion(run_.mesh, h, change);
  }
  return false;
}

void LocalSearch::offerAtEdges(Face f, std::initializer_list<EdgeMove> moves) {
  for (int i = 0; i < 3; ++i) {
    const Halfedge h = HalfedgeMesh::halfedge(f, i);
    for (const EdgeMove move : moves) {
      const bool hasWays = move != EdgeMove::Flip && move != EdgeMove::Split;
      if (hasWays && isAtHub(h)) continue;
      const Halfedge back = hasWays ? run_.mesh.mesh().twin(h) : Halfedge();
      for (const Halfedge way : {h, back})
        if (way && propose(way, move)) offer();
    }
  }
}

// Offers places within each triangle around v, by their weights there, v's first.
void LocalSearch::offerWithin(Vertex v, std::span<const Vec3> weights) {
  std::vector<Halfedge> around;
  run_.mesh.mesh().forEachOutgoing(v, [&](Halfedge h) { around.push_back(h); });
  for (const Halfedge h : around)
    for (const Vec3& w : weights) {
      const Placement place = run_.projector.project(run_.mesh, h, w);
      proposePlacement(run_.mesh, v, place, run_.scratch.change);
      offer();
    }
}

void LocalSearch::offerStepsBetween(Vertex v, double step) {
  offerWithin(v, std::array{Vec3(1 - step, step / 2, step / 2)});
}

void LocalSearch::offerSteps(Vertex v, double step) {
  offerWithin(v, std::array{Vec3(1 - step, step, 0), Vec3(1 - step, step / 2, step / 2)});
}

bool LocalSearch::carryOut() {
  if (best_.gain <= 0) return false;
  run_.scratch.change = best_.change;
  remesher::carryOut(run_, run_.scratch.change);
  return true;
}

}  // namespace remesher
