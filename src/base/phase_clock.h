// SPDX-License-Identifier: MIT
// How long each phase of a run takes, for the report. The clock is read once where a phase begins,
// and no result depends on it.
#pragma once

#include <string_view>
#include <vector>

#include "base/report.h"

namespace remesher {

class PhaseClock {
 public:
  // Ends the phase before and begins this one. A name that was used before, in an earlier part of a
  // file, continues that phase.
  void enter(std::string_view name);

  // Ends the last phase. Returns all phases in the order in which they began; their sum is the run.
  std::vector<Phase> finish();

 private:
  void leave();

  std::vector<Phase> phases_;
  std::size_t current_ = 0;
  double entered_ = 0;
};

// The four times of the report, summed by the phases' names.
Timings timingsOf(const std::vector<Phase>& phases);

}  // namespace remesher
