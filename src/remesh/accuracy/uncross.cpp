// SPDX-License-Identifier: MIT
#include "remesh/accuracy/uncross.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "remesh/gate/angles.h"

namespace remesher {

namespace {

// The proposal that leaves the fewest intersecting pairs; among equals, the one with the widest
// smallest angle.
class FewestPairs {
 public:
  explicit FewestPairs(const Run& run) : rule_(lenient(run)) { rule_.guard = nullptr; }

  void offer(const Run& run) {
    const std::ptrdiff_t growth = run.asked.rule.guard->growth(run.scratch.change);
    if (growth >= 0 || growth > growth_) return;
    const double angle = smallestComingAngle(run.mesh, run.scratch.change);
    if (growth == growth_ && angle <= angle_) return;
    if (judge(run.mesh, run.scratch.change, rule_) != Verdict::Accepted) return;
    growth_ = growth, angle_ = angle, change_ = run.scratch.change;
  }

  bool carryOut(Run& run) const {
    if (growth_ >= 0) return false;
    remesher::carryOut(run, change_);
    return true;
  }

 private:
  FidelityRule rule_;  // without the guard, which is asked separately
  LocalChange change_ = {};
  std::ptrdiff_t growth_ = 0;
  double angle_ = 0;
};

// Offers to put v back on the surface, and to move it towards the middles of the triangles around.
void offerMoves(Run& run, Vertex v, FewestPairs& best) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
  if (run.mesh.kind(v) != VertexKind::Interior) return;
  proposePlacement(run.mesh, v, run.mesh.onSurface(run.mesh.at(v)), run.scratch.change);
  best.offer(run);
  std::vector<Halfedge> around;
  mesh.forEachOutgoing(v, [&](Halfedge h) { around.push_back(h); });
  for (const Halfedge h : around)
    for (const double step : {0.15, 0.3, 0.6})
      if (proposeRelocation(run.mesh, run.projector, {h, {1 - step, step / 2, step / 2}},
                            run.scratch.change))
        best.offer(run);
}

void offerAtEdge(Run& run, Halfedge h, FewestPairs& best) {
  if (proposeFlip(run.mesh, h, run.scratch.change)) best.offer(run);
  if (proposeSplit(run.mesh, run.projector, h, run.scratch.change)) best.offer(run);
  for (const Halfedge way : {h, run.mesh.mesh().twin(h)}) {
    if (!way) continue;
    if (proposeCollapseInto(run.mesh, way, run.scratch.change)) best.offer(run);
    if (proposeCollapse(run.mesh, run.projector, way, run.scratch.change)) best.offer(run);
  }
}

double lengthOf(const Run& run, Halfedge h) {
  return (run.mesh.position(run.mesh.mesh().tip(h)) - run.mesh.position(run.mesh.mesh().origin(h)))
      .norm();
}

bool mendCrossed(Run& run, Face f) {
  FewestPairs best(run);
  for (int k = 0; k < 3; ++k) offerAtEdge(run, HalfedgeMesh::halfedge(f, k), best);
  for (const Vertex v : run.mesh.mesh().vertices(f)) offerMoves(run, v, best);
  return best.carryOut(run);
}

// Halves a triangle for which nothing helps at once: a finer mesh is nearer to the original, which
// does not meet itself.
void halve(Run& run, Face f) {
  Halfedge longest = HalfedgeMesh::halfedge(f);
  for (int k = 1; k < 3; ++k)
    if (const Halfedge h = HalfedgeMesh::halfedge(f, k); lengthOf(run, h) > lengthOf(run, longest))
      longest = h;
  if (!proposeSplit(run.mesh, run.projector, longest, run.scratch.change)) return;
  FidelityRule rule = lenient(run);
  rule.guard = nullptr;  // both halves may meet what the whole does
  commit(run, rule);
}

}  // namespace

std::size_t uncross(Run& run) {
  const int rounds = 2 * run.asked.effort.polishRounds;
  // Mending one triangle takes as long as so many triangles of the original take when all is made
  // anew.
  constexpr std::size_t kWorthMending = 64;
  std::size_t budget = run.mesh.surface().mesh().faceCount() / kWorthMending;
  std::vector<Face> crossed = run.asked.rule.guard->crossing();
  double last = kInfinity, beforeLast = kInfinity;  // how many there were
  for (int round = 0; round < rounds && !crossed.empty(); ++round) {
    // In vain if the rounds to come would not mend all at the rate of the last two. One round alone
    // may leave more than there were, for halves meet what the whole did.
    const double now = double(crossed.size());
    const bool isInVain = (beforeLast - now) / 2 * (rounds - round) < now;
    beforeLast = std::exchange(last, now);
    if (crossed.size() > budget || isInVain) break;
    budget -= crossed.size();
    for (const Face f : crossed)
      if (run.mesh.mesh().isAlive(f) && run.asked.rule.guard->isCrossed(f) && !mendCrossed(run, f))
        halve(run, f);
    crossed = run.asked.rule.guard->crossing();
  }
  return crossed.size();
}

}  // namespace remesher
