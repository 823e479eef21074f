// SPDX-License-Identifier: MIT
#include "schemes/best.h"

#include <cmath>

#include "operators/delaunay.h"
#include "schemes/adapt.h"
#include "schemes/fit.h"
#include "schemes/polish.h"
#include "schemes/relax.h"
#include "schemes/subdivide.h"
#include "schemes/sweeps.h"
#include "schemes/tips.h"
#include "schemes/valence.h"

namespace remesher {

namespace {

constexpr int kAnnealRounds = 20;
constexpr double kTipTolerance = 0.35;
constexpr double kPolishBelow = radians(35);

// Two levels pay only for large meshes.
constexpr std::size_t kManyVertices = 40000;

int levelCount(std::size_t vertices) { return vertices < kManyVertices ? 1 : 2; }

void smooth(Run& run) {
  for (int i = 0; i < 2; ++i) {
    relax(run, 4);
    delaunayFlips(run.mesh, run.rule);
  }
}

}  // namespace

bool runBest(Run& run, std::size_t vertices, const Progress& progress) {
  const int levels = levelCount(vertices);
  run.scale = std::pow(2.0, levels);
  const HalfedgeMesh& mesh = run.mesh.mesh();
  std::size_t base = vertices >> (2 * levels);
  adaptToSizes(run, base, progress.part("adapt", 0, 0.3));
  while (subdividedCount(mesh, base, levels) < vertices) ++base;
  matchCount(run, base);
  annealValences(run, kAnnealRounds, progress.part("anneal", 0.3, 0.6));
  for (int i = 0; i < levels; ++i) {
    subdivide(run);
    smooth(run);
  }
  const bool reached = matchCount(run, vertices);
  smooth(run);
  reachTips(run, kTipTolerance);
  smooth(run);
  polish(run, kPolishBelow);
  fit(run, progress.part("fit", 0.9, 1));
  return reached;
}

}  // namespace remesher
