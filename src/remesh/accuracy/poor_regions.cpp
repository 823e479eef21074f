// SPDX-License-Identifier: MIT
#include "remesh/accuracy/poor_regions.h"

#include "remesh/accuracy/lower_hausdorff.h"
#include "remesh/gate/angles.h"
#include "remesh/steps/polish.h"

namespace remesher {

void mendPoorRegions(Run& run) {
  const FidelityRule rule = run.asked.rule;
  run.asked.rule.mode = Fidelity::Fold;
  polish(run, {kPoor, kSmallShift});
  lowerHausdorff(run);
  run.asked.rule = rule;
}

}  // namespace remesher
