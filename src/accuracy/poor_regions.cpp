// SPDX-License-Identifier: MIT
#include "accuracy/poor_regions.h"

#include "accuracy/lower_hausdorff.h"
#include "steps/polish.h"

namespace remesher {

namespace {

constexpr double kPoor = radians(20);

}  // namespace

void mendPoorRegions(Run& run) {
  const FidelityRule rule = run.rule;
  run.rule.mode = Fidelity::Fold;
  polish(run, {kPoor, kSmallShift});
  lowerHausdorff(run);
  run.rule = rule;
}

}  // namespace remesher
