// SPDX-License-Identifier: MIT
// Mends the last few bad triangles one by one: by flips, moves found by search and, where those do
// not help, a collapse or a split. Leaves no bad triangle where the surface allows a good one, and
// never piles up vertices where it does not.
#pragma once

#include "remesh/steps/run.h"

namespace remesher {

// A step's shift, in target edge lengths.
constexpr double kSmallShift = 0.16;

// Drastic means may multiply the number of vertices by this before the count is put right again.
inline constexpr double kMostGrowth = 1.25;

struct PolishGoal {
  double angle;              // radians; triangles with a smaller one are worked on
  double shift = kInfinity;  // of a step, in target edge lengths
};

// Whether hardly any triangle has a smaller angle. Many have one between curves and around handles
// that are narrower than the edges are long: no step helps them, and each costs distance.
bool areFewBelow(const Run& run, double angle);

// Keeps the number of vertices. No step moves the surface by more than the goal's shift.
void polish(Run& run, const PolishGoal& goal, const Progress& progress = {});

}  // namespace remesher
