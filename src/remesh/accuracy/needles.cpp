// SPDX-License-Identifier: MIT
#include "remesh/accuracy/needles.h"

#include <algorithm>
#include <vector>

#include "geometry/pattern_search.h"
#include "remesh/gate/angles.h"
#include "remesh/gate/sharp_tips.h"
#include "remesh/operators/shift.h"
#include "remesh/steps/local_search.h"

namespace remesher {

namespace {

double smallestGone(const Run& run, const LocalChange& change) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
  const Quantum& quantum = run.asked.rule.quantum;
  double smallest = smallestGoingAngle(run.mesh, change, quantum);
  if (change.operation == Operation::Collapse)
    for (const Halfedge side : {change.halfedge, mesh.twin(change.halfedge)})
      if (side)  // a border has one
        smallest = std::min(smallest, smallestAngle(run.mesh, HalfedgeMesh::face(side), quantum));
  return smallest;
}

// By how much the proposal at hand enlarges the smallest angle. Normals at corners say too little
// of triangles this thin: whether they are lines, how far the surface moves and whether it meets
// itself says enough. shift: the largest one, in model units.
double wideningOf(const Run& run, double shift, double least, WorkBudget& budget) {
  const FidelityRule& rule = run.asked.rule;
  const LocalChange& change = run.scratch.change;
  budget.spend(double(change.coming.size()));
  const double gain =
      smallestComingAngle(run.mesh, change, rule.quantum) - smallestGone(run, change);
  if (gain <= least || flattens(run.mesh, change, rule.quantum)) return 0;
  if (blunts(run.mesh, change, 2 * kSliver)) return 0;
  return shiftsBeyond(shift, run.mesh, change) || !rule.guard->allows(change) ? 0 : gain;
}

// Whether a change leaves no needle.
bool mends(const Run& run, const BestChange& best) {
  return best.gain > 0 &&
         !isNeedle(smallestComingAngle(run.mesh, best.change, run.asked.rule.quantum));
}

// The shortest step of a corner that leaves no needle; if there is none, that which gains most.
BestChange bestStep(Run& run, Face f, const Objective& objective) {
  BestChange best;
  searchPattern([&](double step) {
    LocalSearch search(run, objective);
    for (const Vertex v : run.mesh.mesh().vertices(f))
      if (mayBeReleased(run.mesh, v)) search.offerSteps(v, step);
    if (mends(run, search.best()) || (!mends(run, best) && search.best().gain > best.gain))
      best = search.best();
    return false;
  });
  return best;
}

// A vertex that moves or vanishes is on no curve any more, where that is in the way.
void release(Run& run, const LocalChange& change) {
  LocalChange ownWay;
  if (change.operation == Operation::Relocate) run.mesh.release(change.vertex);
  if (change.operation == Operation::Collapse &&
      !proposeCollapseInto(run.mesh, change.halfedge, ownWay))
    run.mesh.release(run.mesh.mesh().origin(change.halfedge));
}

bool mendNeedle(Run& run, Face f, double farthest, WorkBudget& budget) {
  const Vertex v = run.mesh.mesh().vertices(f)[0];
  // A cell of the lattice that repair's surfaces follow is half an edge wide.
  const double shift = std::min(farthest, 0.5 * run.asked.scale * run.sizes.at(run.mesh.at(v)));
  const Objective objective = [&](double least) { return wideningOf(run, shift, least, budget); };
  LocalSearch search(run, objective, nullptr, bestStep(run, f, objective));
  if (!mends(run, search.best()))
    search.offerAtEdges(f, {EdgeMove::Flip, EdgeMove::CollapseInto, EdgeMove::Unite});
  if (search.best().gain > 0) release(run, search.best().change);
  return search.carryOut();
}

}  // namespace

bool mendNeedles(Run& run, double farthest, WorkBudget& budget) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
  // Not only the needles of now: a change may make a needle of a triangle that follows.
  std::vector<Face> all;
  for (Face f(0); f.index < mesh.faceCapacity(); ++f.index) all.push_back(f);
  const auto isBad = [&](Face f) {
    return !budget.isSpent() && mesh.isAlive(f) &&
           isNeedle(smallestAngle(run.mesh, f, run.asked.rule.quantum));
  };
  return mendEach(all, 1, isBad, [&](Face f) { return mendNeedle(run, f, farthest, budget); });
}

}  // namespace remesher
