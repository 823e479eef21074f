// SPDX-License-Identifier: MIT
// Times for the report; nothing that is computed depends on them.
#pragma once

#include <chrono>

namespace remesher {

class Stopwatch {
 public:
  double milliseconds() const {
    return std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

}  // namespace remesher
