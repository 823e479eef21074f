// SPDX-License-Identifier: MIT
#include "remesh/schemes/uncrossed.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "base/fires.h"
#include "base/patience.h"
#include "remesh/accuracy/needles.h"
#include "remesh/accuracy/uncross.h"
#include "remesh/gate/angles.h"
#include "remesh/schemes/reproject.h"
#include "remesh/steps/adapt.h"
#include "remesh/steps/coarsen.h"
#include "remesh/steps/delaunay.h"
#include "remesh/steps/polish.h"
#include "remesh/steps/relax.h"
#include "remesh/steps/valence.h"

namespace remesher {

namespace {

std::unique_ptr<CrossingGuard> guardOf(Run& run) {
  auto guard = std::make_unique<CrossingGuard>(run.mesh, run.asked.rule.quantum);
  run.asked.rule.guard = guard.get();
  return guard;
}

// Starts from the original, thinned out without looking for crossings, which is faster; only as far
// as the crossings can then be mended.
std::unique_ptr<CrossingGuard> startAnew(Run& run, std::size_t vertices) {
  std::size_t thinned = 0;
  for (std::size_t times = 2; times <= 16; times *= 2) {
    if (times * vertices < thinned) continue;  // the same again
    if (times > 2) fires("uncrossed: decimated less, since crossings could not be mended");
    run.mesh = WorkingMesh(run.mesh.surface());
    if (times * vertices >= run.mesh.mesh().vertexCount()) break;
    run.asked.rule.guard = nullptr;
    coarsen(run, times * vertices, MeetingPlace::MiddleOrEnds);
    thinned = run.mesh.mesh().vertexCount();
    std::unique_ptr<CrossingGuard> guard = guardOf(run);
    if (uncross(run, guard->crossing()) == 0) return guard;
  }
  fires("uncrossed: from the original itself");
  run.mesh = WorkingMesh(run.mesh.surface());
  return guardOf(run);
}

bool finishUncrossed(Run& run, std::size_t vertices) {
  const bool isReached = matchCount(run, vertices);
  polish(run, {kFair});
  return isReached && run.mesh.mesh().vertexCount() == vertices;
}

double tooMany(const Run& run, std::size_t vertices) {
  return std::max(0.0, double(run.mesh.mesh().vertexCount()) - double(vertices));
}

// Makes edges even, with every step that suits a mesh of one level.
bool makeAnew(Run& run, std::size_t vertices) {
  coarsen(run, vertices, MeetingPlace::MiddleOrEnds);
  Prospect prospect(run.asked.effort.adaptRounds);
  while (prospect.isGood(tooMany(run, vertices))) {
    delaunayFlips(run.mesh, run.asked.rule);
    valenceFlips(run);
    relax(run, run.asked.effort.passes);
    matchCount(run, vertices);
  }
  return finishUncrossed(run, vertices);
}

Uncrossed madeAnew(Run& run, std::size_t vertices, std::unique_ptr<CrossingGuard> guard) {
  const bool isReached = makeAnew(run, vertices);
  const std::size_t crossing = guard->crossing().size();
  return {std::move(guard), isReached, crossing};
}

// Mends triangles where they are, if no more than `most` meet others; some may be left.
Uncrossed mended(Run& run, std::size_t vertices, std::size_t most) {
  std::unique_ptr<CrossingGuard> guard = guardOf(run);
  std::vector<Face> crossed = guard->crossing();
  if (crossed.empty()) return {std::move(guard), true, 0};
  if (crossed.size() > most) return {std::move(guard), false, crossed.size()};
  const std::size_t left = uncross(run, std::move(crossed));
  if (left > 0) return {std::move(guard), false, left};
  fires("uncrossed: mended");
  return {std::move(guard), finishUncrossed(run, vertices), 0};
}

Uncrossed uncrossed(Run& run, std::size_t vertices) {
  Uncrossed result = mended(run, vertices, run.mesh.mesh().faceCount());
  if (result.crossing == 0) return result;
  fires("uncrossed: made anew");
  return madeAnew(run, vertices, startAnew(run, vertices));
}

Uncrossed withoutNeedles(Run& run, std::size_t vertices, double farthest, Uncrossed result) {
  const FidelityRule& rule = run.asked.rule;
  if (rule.mode != Fidelity::Fold || rule.bound) return result;
  Prospect prospect(2 * run.asked.effort.polishRounds);
  // Where needles can be mended they take a few tens of places for each triangle of the mesh.
  constexpr double kPlacesPerTriangle = 300;
  WorkBudget budget(kPlacesPerTriangle * double(run.mesh.mesh().faceCount()));
  while (prospect.isGood(tooMany(run, vertices)) && mendNeedles(run, farthest, budget))
    result.isReached = matchCount(run, vertices);
  if (budget.isSpent()) fires("uncrossed: most places for needles");
  return result;
}

}  // namespace

Uncrossed keepUncrossed(Run& run, std::size_t vertices, double farthest) {
  return withoutNeedles(run, vertices, farthest, uncrossed(run, vertices));
}

Uncrossed mendUncrossed(Run& run, std::size_t vertices) {
  constexpr std::size_t kMostOfMesh = 8;  // of more triangles that meet others, some always do
  return mended(run, vertices, run.mesh.mesh().faceCount() / kMostOfMesh);
}

void makeThinned(Run& run, std::size_t vertices) {
  reproject(run);
  run.asked.rule = lenient(run);
  run.mesh = WorkingMesh(run.mesh.surface());
  makeAnew(run, vertices);
}

Uncrossed makeUncrossed(Run& run, std::size_t vertices, double farthest) {
  reproject(run);
  run.asked.rule = lenient(run);
  return withoutNeedles(run, vertices, farthest, madeAnew(run, vertices, startAnew(run, vertices)));
}

}  // namespace remesher
