// SPDX-License-Identifier: MIT
// How long each phase of a run takes, for the report: the clock is read once where a phase begins,
// and nothing that is computed depends on it.
#pragma once

#include <string_view>
#include <vector>

#include "base/report.h"

namespace remesher {

class PhaseClock {
 public:
  // The phase before ends, this one begins. One of a name that was here before, in an earlier part
  // of a file, goes on where that one ended.
  void enter(std::string_view name);

  // The last phase ends; all of them in the order in which they began, and their sum is the run.
  std::vector<Phase> finish();

 private:
  void leave();

  std::vector<Phase> phases_;
  std::size_t current_ = 0;
  double entered_ = 0;
};

// The four times of the report, by the names of the phases.
Timings timingsOf(const std::vector<Phase>& phases);

}  // namespace remesher
