// SPDX-License-Identifier: MIT
// Pattern search [Hooke & Jeeves 1961]: a step each way, and half the step where none is better.
#pragma once

#include <array>
#include <numbers>

#include "base/types.h"

namespace remesher {

// The ways in a plane, of length 1.
inline std::array<Vec2, 8> planeDirections() {
  constexpr double half = 1 / std::numbers::sqrt2;
  return {Vec2(1, 0),  Vec2(half, half),   Vec2(0, 1),  Vec2(-half, half),
          Vec2(-1, 0), Vec2(-half, -half), Vec2(0, -1), Vec2(half, -half)};
}

// look: takes a step in mean spokes of the star that is searched, looks that far each way, and
// returns whether a place was better. Of 33 cases at 7 neighboring counts each, in a trial where
// all searches had the same steps, from 0.4 to 0.04 smallest angles came out 0.8° smaller on
// average and 0.4 points fewer triangles even.
template <class Look>
void searchPattern(const Look& look) {
  // Hausdorff distances of 3 cases at 7 neighboring counts are 1.04 to 1.28 times as large with .15
  // as the first step and .96 to 1.06 times with .6, in up to 1.4 times the time. With .01 as the
  // last step they are .94 to 1.03 times as large, with .04 .91 to 1.21 times.
  constexpr double kFirstStep = 0.3, kLastStep = 0.02;
  // To a place a billion spokes away a search would take as many steps, each a little nearer.
  // With 16, 25 of 35 results (5 cases at 7 neighboring counts) are the same, with 32 all are.
  constexpr int kMostSteps = 64;
  double step = kFirstStep;
  for (int i = 0; i < kMostSteps && step >= kLastStep; ++i)
    if (!look(step)) step /= 2;
}

}  // namespace remesher
