// SPDX-License-Identifier: MIT
// A small seeded generator: the same numbers on every run and engine [Marsaglia 2003, xorshift32].
#pragma once

#include <cstdint>

namespace remesher {

class Random {
 public:
  explicit Random(std::uint32_t seed) : state_(seed != 0 ? seed : 1) {}

  double uniform() {  // in [0, 1)
    state_ ^= state_ << 13;
    state_ ^= state_ >> 17;
    state_ ^= state_ << 5;
    return state_ / 4294967296.0;
  }

 private:
  std::uint32_t state_;  // never 0
};

}  // namespace remesher
