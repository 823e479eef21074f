// SPDX-License-Identifier: MIT
#include "schemes/bound_error.h"

#include <algorithm>
#include <limits>

#include "operators/delaunay.h"
#include "schemes/adapt.h"
#include "schemes/coarsen.h"
#include "schemes/polish.h"
#include "schemes/refine_excess.h"
#include "schemes/relax.h"
#include "schemes/valence.h"

namespace remesher {

namespace {

constexpr int kPatience = 6;            // rounds within which what is left must halve
constexpr int kMovingRounds = 6;        // two places could want one vertex by turns for ever
constexpr double kMostVertices = 1.25;  // times those that the scheme made
constexpr double kPolishBelow = radians(30);

// A few rounds mend what a scheme has left. Where there is much of it, or where it does not shrink,
// for the mesh stands for the original in the wrong places, it is not worth mending. Returns
// whether the bound is kept in the end.
bool mend(Run& run, const ErrorBound& bound, const Progress& progress) {
  const HalfedgeMesh& mesh = run.mesh.mesh();
  const double most = kMostVertices * double(mesh.vertexCount());
  std::size_t halfOfEarlier = std::numeric_limits<std::size_t>::max();
  for (int round = 0; double(mesh.vertexCount()) <= most; ++round) {
    progress.at(double(round) / (round + kPatience));
    const ErrorBound::Excess excess = bound.excess(run.mesh);
    if (excess.empty()) return true;
    const std::size_t left = excess.stray.size() + excess.lost.size();
    if (round % kPatience == kPatience - 1) {
      if (left > halfOfEarlier) return false;
      halfOfEarlier = left / 2;
    }
    refineExcess(run, excess, round < kMovingRounds ? Moves::Allowed : Moves::Never);
    delaunayFlips(run.mesh, run.rule);
  }
  return false;
}

// The original itself keeps every bound, and under the gate so does all that is made of it.
void beginAgain(Run& run, std::size_t vertices, const Progress& progress) {
  run.mesh = WorkingMesh(run.mesh.surface());
  run.scale = 1;
  adaptToSizes(run, vertices, progress.part("adapt", 0, 0.8));
  annealValences(run, 2, progress.part("anneal", 0.8, 0.9));
  coarsen(run, vertices, MeetingPlace::MiddleOrEnds);
  progress.at(0.95);
  relax(run, 2);
}

}  // namespace

bool boundError(Run& run, const BoundGoal& goal, const Progress& progress) {
  const bool isMended = mend(run, goal.bound, progress.part("mend", 0, 0.3));
  run.rule.bound = &goal.bound;
  if (!isMended) beginAgain(run, goal.vertices, progress.part("adapt", 0.3, 0.8));
  coarsen(run, goal.vertices, MeetingPlace::MiddleOrEnds);
  matchCount(run, goal.vertices);
  progress.at(0.9);
  delaunayFlips(run.mesh, run.rule);
  polish(run, {kPolishBelow});
  return run.mesh.mesh().vertexCount() == goal.vertices;
}

}  // namespace remesher
