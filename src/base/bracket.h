// SPDX-License-Identifier: MIT
// A search for the smallest number that suffices, where each number must be tried: the numbers
// between which it lies. From some number on nearly all suffice; where one beyond does not, the
// search ends all the same, at a number that suffices, beside one that does not.
#pragma once

#include <cmath>

namespace remesher {

struct Bracket {
  double fails = 0;  // the largest known not to suffice; 0 if none is known
  double does = 0;   // the smallest known to suffice; 0 if none is known

  bool isClosed() const { return fails > 0 && does > 0; }

  // Whether the number that suffices is at most so many times the other.
  bool isWithin(double ratio) const { return isClosed() && does <= ratio * fails; }

  // Whether no whole number lies between them.
  bool isEmpty() const { return isClosed() && does - fails <= 1; }

  // The number to try next: the geometric mean of both, or `step` times smaller or larger than the
  // one that is known.
  double next(double step) const {
    if (isClosed()) return std::sqrt(fails * does);
    return does > 0 ? does / step : fails * step;
  }
};

}  // namespace remesher
