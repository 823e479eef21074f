// SPDX-License-Identifier: MIT
#include "remesh/schemes/best.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "original/surface/curvature.h"
#include "remesh/accuracy/fit.h"
#include "remesh/accuracy/lower_hausdorff.h"
#include "remesh/accuracy/narrow_sizes.h"
#include "remesh/accuracy/tips.h"
#include "remesh/gate/angles.h"
#include "remesh/schemes/reproject.h"
#include "remesh/schemes/targets.h"
#include "remesh/steps/adapt.h"
#include "remesh/steps/boundaries.h"
#include "remesh/steps/delaunay.h"
#include "remesh/steps/left_out.h"
#include "remesh/steps/polish.h"
#include "remesh/steps/relax.h"
#include "remesh/steps/subdivide.h"
#include "remesh/steps/sweeps.h"
#include "remesh/steps/valence.h"

namespace remesher {

namespace {

// Corners never move: a coarse mesh needs so many vertices per corner.
constexpr std::size_t kVerticesPerCorner = 8;
// The largest mean bend over a coarse edge. Six edges as long as the radius go around a tube (a
// bend of 1); with fewer edges the tube falls flat, and no later vertex raises it again.
constexpr double kMostBend = 0.9;

// How the vertices are made: a coarse mesh, subdivided `count` times.
struct Levels {
  int count;
  std::size_t coarse;  // vertices of the coarse mesh, at first
  std::size_t vertices;
  Quality quality;

  const Effort& effort(int level) const {
    const bool isFinest = level == count;
    return effortOf(quality, isFinest ? Level::Finest : Level::Coarse,
                    isFinest ? vertices : coarse << (2 * level));
  }
};

Levels planLevels(const Run& run, const BestGoal& goal) {
  const std::size_t vertices = goal.vertices;
  const HalfedgeMesh& original = run.mesh.surface().mesh();
  const FeatureCurves& curves = run.mesh.surface().curves();
  const std::size_t corners = countCorners(curves, original);
  const auto& chains = curves.chains();
  // Subdividing would divide kept chains, and spikes.
  const bool isKept =
      std::any_of(chains.begin(), chains.end(), [](const Chain& c) { return c.kept; });
  if (isKept || run.sizes.isSpiked()) return {0, vertices, vertices, goal.quality};
  int levels = vertices < kLarge ? 1 : 2;
  const double area = run.mesh.surface().area();
  const double bend = meanBend(run.mesh.surface());
  const auto isTooCoarse = [&](std::size_t coarse) {
    return coarse < kVerticesPerCorner * corners ||
           bend * evenEdgeLength(area, double(coarse)) > kMostBend;
  };
  while (levels > 0 && isTooCoarse(vertices >> (2 * levels))) --levels;
  return {levels, vertices >> (2 * levels), vertices, goal.quality};
}

// A step, unless the ablation benchmark leaves it out.
template <class Step>
void take(std::string_view name, Step step) {
  if (!isLeftOut(name)) step();
}

void smooth(Run& run) {
  const int smoothings = isLeftOut("second smoothing") ? 1 : run.asked.effort.smoothings;
  for (int i = 0; i < smoothings; ++i) {
    relax(run, run.asked.effort.passes);
    delaunayFlips(run.mesh, run.asked.rule);
  }
}

// Restores the density that the caller wishes, which hysteresis between splits and collapses and
// smoothing over ever more regular valences blur: adds some vertices where edges are too long, and
// removes as many where edges are too short.
void evenOut(Run& run, std::size_t vertices) {
  for (const std::size_t count : {vertices + vertices / 10, vertices}) {
    matchCount(run, count);
    delaunayFlips(run.mesh, run.asked.rule);
    valenceFlips(run);
    smooth(run);
  }
}

void smoothOntoTips(Run& run) {
  take("tips", [&] { reachTips(run); });
  smooth(run);
}

// The vertices that the farthest places take are given back where they are missed least, when the
// count is matched.
void reachFarPlaces(Run& run) {
  const std::size_t more = narrowSizes(run);
  if (more == 0) return;
  matchCount(run, run.mesh.mesh().vertexCount() + more);
  delaunayFlips(run.mesh, run.asked.rule);
  valenceFlips(run);
  smooth(run);
}

// Following the boundaries adds vertices; matching the count removes some, at boundaries too.
bool followToCount(Run& run, std::size_t vertices) {
  bool reached = false;
  const int rounds = isLeftOut("second count") ? 1 : 2;
  for (int i = 0; i < rounds; ++i) {
    followBoundaries(run);
    reached = matchCount(run, vertices);
    take("smoothing at the count", [&] { smooth(run); });
  }
  take("settle boundaries", [&] { settleBoundaries(run); });
  return reached;
}

// Makes the coarse mesh, with the vertices that the levels turn into the wished number, or a few
// more; nearly all vertices are regular, and the tips of the original are reached.
void makeCoarse(Run& run, const Levels& levels, const Progress& progress) {
  run.asked.scale = std::pow(2.0, levels.count);
  run.asked.effort = levels.effort(0);
  adaptToSizes(run, levels.coarse, progress.phase("adapt", 0, 0.55));
  const std::size_t coarse = coarseCount(run.mesh.mesh(), levels.vertices, levels.count);
  matchCount(run, coarse);
  const int rounds = isLeftOut("half of annealing") ? run.asked.effort.annealRounds / 2
                                                    : run.asked.effort.annealRounds;
  annealValences(run, rounds, progress.phase("anneal", 0.55, 1));
  if (run.sizes.isWished()) evenOut(run, coarse);
  progress.phase("tips", 1, 1);
  smoothOntoTips(run);
  matchCount(run, coarse);
}

// Refines to the level of the result and to the exact number. Returns whether the number was
// reached.
bool refine(Run& run, const Levels& levels, const Progress& progress) {
  for (int i = 0; i < levels.count; ++i) {
    progress.phase("refine", double(i) / levels.count, 1);
    subdivide(run);
    run.asked.effort = levels.effort(i + 1);
    take("smoothing after subdividing", [&] { smooth(run); });
  }
  if (levels.quality == Quality::Best) {
    progress.phase("tips", 1, 1);
    smoothOntoTips(run);
    take("narrow sizes", [&] { reachFarPlaces(run); });
  }
  progress.phase("count", 1, 1);
  return followToCount(run, levels.vertices);
}

// One pass of fitting goes half of the way from triangles that cut into the surface to triangles
// that follow it. The worst triangles are mended; the farthest places are left.
void finishDraft(Run& run, const Progress& progress) {
  reproject(run);
  fit(run, progress.phase("fit", 0, 1));
  progress.phase("polish", 1, 1);
  polish(run, {kFair});
}

// Brings the mesh nearer to the original, and leaves no triangle that could be better.
void finish(Run& run, const Progress& progress) {
  progress.phase("polish", 0, 0);
  if (areFewBelow(run, kSound)) take("widen angles", [&] { widenAngles(run); });
  take("polish", [&] { polish(run, {kFine}); });
  progress.phase("reproject", 0, 0);
  reproject(run);
  take("fit", [&] { fit(run, progress.phase("fit", 0, 1)); });
  progress.phase("lower Hausdorff", 1, 1);
  take("lower Hausdorff", [&] { lowerHausdorff(run); });
  progress.phase("polish", 1, 1);
  if (run.mesh.mesh().vertexCount() >= kLarge || !areFewBelow(run, kSound)) return;
  take("last polish", [&] { polish(run, {kFine, kPlainlyNear}); });
}

}  // namespace

bool runBest(Run& run, const BestGoal& goal, const Progress& progress) {
  const Levels levels = planLevels(run, goal);
  const bool isDraft = goal.quality == Quality::Draft;
  run.asked.boundaries = Boundaries::Staggered;
  makeCoarse(run, levels, progress.part(0, 0.45));
  const bool reached = refine(run, levels, progress.part(0.45, 0.85));
  if (goal.comparison && !isDraft && goal.comparison->endsEarly(run.mesh)) return reached;
  const Progress last = progress.part(0.85, 1);
  isDraft ? finishDraft(run, last) : finish(run, last);
  return reached;
}

}  // namespace remesher
