// SPDX-License-Identifier: MIT
// How much work a run puts into each step: the one table of what depends on quality and on size.
#pragma once

#include <cstddef>

#include "base/options.h"

namespace remesher {

// From this many vertices on edges are so short that a walk over the original ends where a patch
// would lead.
inline constexpr std::size_t kMany = 8000;
// From here on a step costs seconds, and nobody sees a few triangles more or less near a limit.
inline constexpr std::size_t kLarge = 100'000;

struct Effort {
  int adaptRounds;        // of splits, collapses and flips towards the sizes
  int adaptSweeps;        // smoothing sweeps in each of those rounds
  std::size_t thinAbove;  // beyond so many times the wanted vertices a mesh is thinned out
  int annealRounds;       // of flips that let irregular vertices meet and cancel
  int smoothings;         // at each level
  int passes;             // over the vertices in each smoothing
  double rest;            // a vertex rests while its neighbours' mean moves less; target lengths
  int widenings;          // passes that widen the angles around irregular vertices
  int polishRounds;       // over the bad triangles
  int polishPatience;     // rounds in which many bad triangles must not become more
  int polishTries;        // per triangle in a round
  int fitPasses;          // of fitting the vertices to the original
};

// The coarse level of a draft: only one of four final vertices is its own, and those that
// subdivision puts between them come out regular.
inline constexpr Effort kSketch = {3, 1, 64, 2, 1, 2, 0.02, 0, 4, 1, 3, 1};
inline constexpr Effort kDraft = {5, 2, 7, 4, 1, 2, 0.02, 0, 4, 1, 3, 1};
// The coarse level of the best quality: the levels after it are smoothed again.
inline constexpr Effort kCoarse = {5, 1, 7, 20, 2, 4, 0.003, 3, 8, 2, 3, 3};
inline constexpr Effort kUsual = {5, 2, 7, 20, 2, 4, 0.003, 3, 8, 2, 3, 3};
// A larger mesh has fewer irregular vertices for its size, and those that annealing cannot reach
// cost less.
inline constexpr Effort kOfLarge = {5, 2, 7, 12, 2, 4, 0.01, 2, 6, 2, 1, 2};

enum class Level { Coarse, Finest };

// vertices: of that level.
constexpr const Effort& effortOf(Quality quality, Level level, std::size_t vertices) {
  if (quality == Quality::Draft) return level == Level::Coarse ? kSketch : kDraft;
  if (vertices >= kLarge) return kOfLarge;
  return level == Level::Coarse ? kCoarse : kUsual;
}

}  // namespace remesher
