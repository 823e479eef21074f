// SPDX-License-Identifier: MIT
// Levels of detail by what is seen of them: how far they are off, in pixels where the whole model is
// as high as a screen, and when they may take over from the finer one.
#pragma once

#include <functional>
#include <vector>

#include "base/options.h"
#include "base/report.h"
#include "io/model/model.h"

namespace remesher {

// Searches for the fewest vertices whose result is off by no more than so many pixels of 1080.
class PixelSearch {
 public:
  // most: the vertices of the finer level.
  PixelSearch(double pixels, std::size_t most);

  // Of the next result.
  Index vertices() const { return next_; }

  // Takes note of that result. Returns whether it is the best so far.
  bool take(const Report& made);

  // Whether no further result can be expected to be better.
  bool isSettled() const { return isSettled_; }

  // Whether the best is off by no more.
  bool isMet() const { return does_ > 0; }

 private:
  double estimate(double percent, double vertices) const;

  double percent_;  // of the diagonal
  double most_;
  double does_ = 0, fails_ = 0;  // vertices of the fewest that do, and of the most that do not
  double least_ = 0;             // percent of the nearest that does not
  Index next_;
  int tries_ = 0;
  bool isSettled_ = false;
};

// When a level may be shown instead of the finer one: `finer` is the report of that.
SwitchReport switchTo(const Report& level, const Report& finer);

// Of each part at its largest place, the share of a screen that its disk covers at the switches.
void setCoverages(std::vector<io::Part>& parts, const Report& finest);

}  // namespace remesher
