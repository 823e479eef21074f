// SPDX-License-Identifier: MIT
#include "remesh/accuracy/bound_error.h"

#include <algorithm>
#include <limits>

#include "base/fires.h"
#include "remesh/accuracy/refine_excess.h"
#include "remesh/gate/angles.h"
#include "remesh/steps/adapt.h"
#include "remesh/steps/coarsen.h"
#include "remesh/steps/delaunay.h"
#include "remesh/steps/polish.h"
#include "remesh/steps/relax.h"

namespace remesher {

namespace {

// Within so many rounds what is left must halve, and afterwards no vertex moves: two places could
// want one vertex by turns for ever.
constexpr int kPatience = 6;

// Beyond this number of vertices mending has no future: the number asked for is out of reach from
// there, and the original itself is nearer to it.
double mostVertices(const Run& run, std::size_t vertices) {
  const double made = double(run.mesh.mesh().vertexCount());
  const double original = double(run.mesh.surface().mesh().vertexCount());
  return std::max(kMostGrowth * double(vertices), std::min(kMostGrowth * made, original));
}

// A few rounds mend the excess that a scheme has left. It is not worth mending if there is much of
// it, or if it does not shrink because the mesh stands for the original in the wrong places.
// Returns whether the bound is kept in the end.
bool mend(Run& run, const BoundGoal& goal, const Progress& progress) {
  const double most = mostVertices(run, goal.vertices);
  ExcessSearch search(goal.bound);
  std::size_t halfOfEarlier = std::numeric_limits<std::size_t>::max();
  for (int round = 0; double(run.mesh.mesh().vertexCount()) <= most; ++round) {
    progress.at(double(round) / (round + 2));  // each takes less time than the one before
    const Excess excess = search.find(run.mesh);
    if (excess.empty()) return true;
    const std::size_t left = excess.stray.size() + excess.lost.size();
    if (round % kPatience == kPatience - 1) {
      if (left > halfOfEarlier) {
        fires("error bound: the excess does not shrink");
        return false;
      }
      halfOfEarlier = left / 2;
    }
    refineExcess(run, excess, round < kPatience ? Moves::Allowed : Moves::Never);
    delaunayFlips(run.mesh, run.asked.rule);
  }
  return false;
}

// Polishing splits and collapses. If the gate refuses collapses, so that the count changes, the
// mesh before is restored.
void polishInCount(Run& run, const Progress& progress) {
  const WorkingMesh before = run.mesh;
  polish(run, {kFair}, progress);
  if (run.mesh.mesh().vertexCount() == before.mesh().vertexCount()) return;
  fires("error bound: polishing undone");
  run.mesh = before;
}

}  // namespace

bool boundError(Run& run, const BoundGoal& goal, const Progress& progress) {
  if (!mend(run, goal, progress.phase("mend", 0, 0.3))) {
    if (goal.outOfBound == OutOfBound::GiveUp) return false;
    fires("error bound: from the original itself");
    run.mesh = WorkingMesh(run.mesh.surface());
  }
  run.asked.scale = 1;
  run.asked.rule.bound = &goal.bound;
  const HalfedgeMesh& mesh = run.mesh.mesh();
  grantProofs(run);
  coarsen(run, goal.vertices, MeetingPlace::MiddleOrEnds, progress.phase("coarsen", 0.3, 0.6));
  const bool isReached = mesh.vertexCount() <= goal.vertices && matchCount(run, goal.vertices);
  delaunayFlips(run.mesh, run.asked.rule);
  grantProofs(run);
  if (isReached)
    polishInCount(run, progress.phase("polish", 0.6, 1));
  else
    relax(run, 2);
  return isReached;
}

}  // namespace remesher
