// SPDX-License-Identifier: MIT
#include "remesh/accuracy/poor_regions.h"

#include "remesh/accuracy/lower_hausdorff.h"
#include "remesh/steps/polish.h"

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
