// SPDX-License-Identifier: MIT
#include "base/phase_clock.h"

#include <algorithm>
#include <ctime>

namespace remesher {
namespace {

// Milliseconds since some fixed moment. C++'s clock may fail, and links in a hundred unrelated
// error messages.
double clockNow() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return 1e3 * double(time.tv_sec) + 1e-6 * double(time.tv_nsec);
}

}  // namespace

void PhaseClock::leave() {
  const double now = clockNow();
  if (!phases_.empty()) phases_[current_].milliseconds += now - entered_;
  entered_ = now;
}

void PhaseClock::enter(std::string_view name) {
  leave();
  const auto known = std::find_if(phases_.begin(), phases_.end(),
                                  [&](const Phase& phase) { return phase.name == name; });
  current_ = std::size_t(known - phases_.begin());
  if (known == phases_.end()) phases_.push_back({std::string(name), 0});
}

std::vector<Phase> PhaseClock::finish() {
  leave();
  return phases_;
}

Timings timingsOf(const std::vector<Phase>& phases) {
  Timings timings;
  for (const auto& [name, milliseconds] : phases) {
    if (name == "read")
      timings.read += milliseconds;
    else if (name == "write")
      timings.write += milliseconds;
    else if (name == "build" || name == "curves" || name == "surface")
      timings.build += milliseconds;
    else if (name != "inspect" && name != "measure")
      timings.remesh += milliseconds;
  }
  return timings;
}

}  // namespace remesher
