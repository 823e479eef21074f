// SPDX-License-Identifier: MIT
// Levels of detail by what is seen of them: how far they are off, in pixels where the whole model
// is as high as a screen.
#pragma once

#include <functional>

#include "base/report.h"
#include "jobs/fewest_vertices.h"
#include "jobs/scene_run.h"

namespace remesher {

// Searches for the fewest vertices whose result is off by no more than so many pixels of 1080.
class PixelSearch {
 public:
  // most: the vertices of the finer level.
  PixelSearch(double pixels, std::size_t most);

  // The number of vertices to try next.
  Index vertices() const { return next_; }

  // Takes note of that result. Returns whether it is the best so far.
  bool take(const Report& made);

  // Whether no further result can be expected to be better.
  bool isSettled() const { return isSettled_; }

  // Whether the best is off by no more.
  bool isMet() const { return tried_.does > 0; }

 private:
  double estimate(double percent, double vertices) const;

  double percent_;  // of the diagonal
  double most_;
  Bracket tried_;     // vertices
  double least_ = 0;  // percent of the nearest that does not
  Index next_;
  int tries_ = 0;
  bool isSettled_ = false;
};

// Makes a level of so many vertices.
using RunOfLevel = std::function<SceneRun(Index vertices)>;

// The level of fewest vertices that is off by no more than so many pixels; with a warning, the
// nearest if none is. finer: the report of the level before it.
SceneRun withinPixels(double pixels, const Report& finer, const RunOfLevel& runAt);

}  // namespace remesher
