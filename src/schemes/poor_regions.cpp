// SPDX-License-Identifier: MIT
#include "schemes/poor_regions.h"

#include "schemes/lower_hausdorff.h"
#include "schemes/polish.h"

namespace remesher {

namespace {

constexpr double kPoor = radians(20);
// Steps above a third of an edge lose tips, below a sixth slivers stay.
constexpr double kShift = 0.25;

}  // namespace

void mendPoorRegions(Run& run) {
  const FidelityRule rule = run.rule;
  run.rule.mode = Fidelity::Fold;
  polish(run, {kPoor, kShift});
  lowerHausdorff(run);
  run.rule = rule;
}

}  // namespace remesher
