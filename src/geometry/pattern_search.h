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
// returns whether a place was better.
template <class Look>
void searchPattern(const Look& look) {
  // In mean spokes.
  constexpr double kFirstStep = 0.3, kLastStep = 0.02;
  // To a place a billion spokes away a search would take as many steps, each a little nearer.
  constexpr int kMostSteps = 64;
  double step = kFirstStep;
  for (int i = 0; i < kMostSteps && step >= kLastStep; ++i)
    if (!look(step)) step /= 2;
}

}  // namespace remesher
