// SPDX-License-Identifier: MIT
// The parts of a file mended, each on its own, and what is to be said of it.
#pragma once

#include <vector>

#include "base/options.h"
#include "base/progress.h"
#include "base/report.h"
#include "io/model/model.h"
#include "jobs/precision.h"
#include "remesh/schemes/remesh.h"

namespace remesher {

struct PartsRepair {
  std::vector<io::Part> parts;
  RepairReport report;
  std::vector<Warning> warnings;
};

// Throws Error as repairSurface does; INVALID_OPTION where the options name vertices of the input.
PartsRepair repairParts(std::vector<io::Part> parts, const RemeshOptions& options,
                        const Progress& progress);

// The outcome of remeshing what was repaired, rounded as inPrecisionOf does: where it is closed, a
// 2-manifold and meets itself nowhere, so is what is returned. That is the original, with a
// warning, if rounding leaves nothing else.
RoundedMesh inSoundPrecisionOf(const TriangleMesh& original, RemeshOutcome& outcome);

// What is broken in all of them: sums, the loops of each in percent of its own diagonal, and the
// repair that reaches farthest.
FaultReport faultsOf(const std::vector<io::Part>& parts);

}  // namespace remesher
