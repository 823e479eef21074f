// SPDX-License-Identifier: MIT
#include "remesh/schemes/best.h"

#include <algorithm>
#include <cmath>

#include "original/surface/curvature.h"
#include "remesh/accuracy/fit.h"
#include "remesh/accuracy/lower_hausdorff.h"
#include "remesh/accuracy/tips.h"
#include "remesh/schemes/land.h"
#include "remesh/schemes/targets.h"
#include "remesh/steps/adapt.h"
#include "remesh/steps/boundaries.h"
#include "remesh/steps/delaunay.h"
#include "remesh/steps/polish.h"
#include "remesh/steps/relax.h"
#include "remesh/steps/subdivide.h"
#include "remesh/steps/sweeps.h"
#include "remesh/steps/valence.h"

namespace remesher {

namespace {

// Irregular vertices of a larger mesh are fewer for its size, and what one round cannot reach costs
// less: rounds are saved there.
constexpr int kAnnealRounds = 20, kFewestRounds = 12;
// A draft that is subdivided needs fewer still.
constexpr int kDraftRounds = 4, kSketchRounds = 2;
constexpr double kManyToAnneal = 6000;
constexpr int kPasses = 4, kDraftPasses = 2;
constexpr int kSmoothings = 2, kDraftSmoothings = 1;
constexpr int kEvenings = 2;
constexpr double kTipTolerance = 0.5;  // of the target edge length
constexpr double kPolishBelow = radians(35);
constexpr double kSliver = radians(10), kPoor = radians(30), kFair = radians(33),
                 kFine = radians(34.5);
constexpr double kHardlyShift = 0.04;  // of the target edge length: not worth a distance

// Two levels pay only for large meshes, none for tiny ones.
constexpr std::size_t kManyVertices = 40000;
constexpr std::size_t kFewVertices = 400;
// Corners never move: a coarse mesh needs so many vertices to each.
constexpr std::size_t kVerticesPerCorner = 6;
// On average, over a coarse edge. Six edges as long as its radius go around a tube (a bend of 1);
// with fewer it falls flat, and no vertex that comes later raises it again.
constexpr double kMostBend = 0.9;

// How the vertices come about: a coarse mesh, subdivided so often.
struct Levels {
  int count;
  std::size_t coarse;  // vertices of the coarse mesh, at first
  std::size_t vertices;
};

Levels planLevels(const Run& run, std::size_t vertices) {
  const HalfedgeMesh& original = run.mesh.surface().mesh();
  const FeatureCurves& curves = run.mesh.surface().curves();
  const std::size_t corners = countCorners(curves, original);
  const auto& chains = curves.chains();
  // Subdividing would divide what is to be kept, and spikes.
  const bool isKept =
      std::any_of(chains.begin(), chains.end(), [](const Chain& c) { return c.kept; });
  if (isKept || run.sizes.isSpiked()) return {0, vertices, vertices};
  int levels = vertices < kFewVertices ? 0 : vertices < kManyVertices ? 1 : 2;
  const double area = run.mesh.surface().area();
  const double bend = levels > 0 ? meanBend(run.mesh.surface()) : 0;
  const auto isTooCoarse = [&](std::size_t coarse) {
    return coarse < kVerticesPerCorner * corners ||
           bend * evenEdgeLength(area, double(coarse)) > kMostBend;
  };
  while (levels > 0 && isTooCoarse(vertices >> (2 * levels))) --levels;
  return {levels, vertices >> (2 * levels), vertices};
}

int annealRounds(const Run& run, const Levels& levels, std::size_t vertices) {
  if (run.quality == Quality::Draft) return levels.count > 0 ? kSketchRounds : kDraftRounds;
  const double share = std::sqrt(kManyToAnneal / double(std::max<std::size_t>(vertices, 1)));
  return std::clamp(int(kAnnealRounds * share), kFewestRounds, kAnnealRounds);
}

void smooth(Run& run) {
  const bool isDraft = run.quality == Quality::Draft;
  const int passes = isDraft ? kDraftPasses : kPasses;
  for (int i = 0; i < (isDraft ? kDraftSmoothings : kSmoothings); ++i) {
    relax(run, passes);
    delaunayFlips(run.mesh, run.rule);
  }
}

// Where the caller has said how dense vertices are to be, and neither hysteresis between splits and
// collapses nor smoothing over ever more regular valences may blur it: some vertices more where
// edges are too long, as many fewer where they are too short.
void evenOut(Run& run, std::size_t vertices) {
  for (int i = 0; i < kEvenings; ++i)
    for (const std::size_t count : {vertices + vertices / 10, vertices}) {
      matchCount(run, count);
      delaunayFlips(run.mesh, run.rule);
      valenceFlips(run);
      smooth(run);
    }
}

void smoothOntoTips(Run& run) {
  reachTips(run, kTipTolerance);
  smooth(run);
}

// Following the boundaries adds vertices, matching the count takes some away, there as well.
bool followToCount(Run& run, std::size_t vertices) {
  bool reached = false;
  for (int i = 0; i < 2; ++i) {
    followBoundaries(run);
    reached = matchCount(run, vertices);
    smooth(run);
  }
  settleBoundaries(run);
  return reached;
}

// As many vertices as the levels make the wished number of, or a few more, nearly all regular, the
// tips of the original reached.
void makeCoarse(Run& run, const Levels& levels, const Progress& progress) {
  run.scale = std::pow(2.0, levels.count);
  adaptToSizes(run, levels.coarse, progress.phase("adapt", 0, 0.55));
  // They come back to as many below: what subdividing makes of them goes.
  const std::size_t crowded = countCrowded(run);
  const std::size_t coarse = coarseCount(run.mesh.mesh(), levels.vertices, levels.count) + crowded -
                             (crowded >> (2 * levels.count));
  matchCount(run, coarse);
  annealValences(run, annealRounds(run, levels, coarse), progress.phase("anneal", 0.55, 1));
  if (run.sizes.isWished()) evenOut(run, coarse);
  progress.phase("tips", 1, 1);
  smoothOntoTips(run);
  matchCount(run, coarse);
}

// Down to the level of the result, and to the exact number. Returns whether it was reached.
bool refine(Run& run, const Levels& levels, const Progress& progress) {
  for (int i = 0; i < levels.count; ++i) {
    progress.phase("refine", double(i) / levels.count, 1);
    subdivide(run);
    thinCrowds(run);
    smooth(run);
  }
  if (run.quality == Quality::Best) {
    progress.phase("tips", 1, 1);
    smoothOntoTips(run);
  }
  progress.phase("count", 1, 1);
  return followToCount(run, levels.vertices);
}

// Half of the way from a surface that the triangles cut into to one that they follow is one pass of
// fitting; the worst triangles are mended, and the farthest places left.
void finishDraft(Run& run, const Progress& progress) {
  land(run);
  fit(run, progress.phase("fit", 0, 1));
  progress.phase("polish", 1, 1);
  polish(run, {kPoor});
}

// Nearer to the original, and no triangle left that could be better.
void finish(Run& run, const Progress& progress) {
  progress.phase("polish", 0, 0);
  if (areFewBelow(run, kFair)) widenAngles(run);
  polish(run, {kPolishBelow});
  progress.phase("land", 0, 0);
  land(run);
  fit(run, progress.phase("fit", 0, 1));
  progress.phase("lower Hausdorff", 1, 1);
  lowerHausdorff(run);
  progress.phase("polish", 1, 1);
  polish(run, {kSliver});
  if (isLarge(run) || !areFewBelow(run, kFair)) return;
  polish(run, {kFair, kSmallShift});
  if (!areFewBelow(run, kFine)) return;
  polish(run, {kFine, kHardlyShift});
  polish(run, {kFair, kSmallShift});  // what the number of vertices has cost there
}

}  // namespace

bool runBest(Run& run, std::size_t vertices, Rival* rival, const Progress& progress) {
  const Levels levels = planLevels(run, vertices);
  run.boundaries = Boundaries::Staggered;
  makeCoarse(run, levels, progress.part(0, 0.45));
  const bool reached = refine(run, levels, progress.part(0.45, 0.85));
  if (rival && run.quality == Quality::Best && rival->hasWon(run.mesh)) return reached;
  const Progress last = progress.part(0.85, 1);
  run.quality == Quality::Draft ? finishDraft(run, last) : finish(run, last);
  return reached;
}

}  // namespace remesher
