// SPDX-License-Identifier: MIT
// Repairs the parts of a file, each on its own, with report and warnings.
#pragma once

#include <vector>

#include "base/part_options.h"
#include "base/progress.h"
#include "base/report.h"
#include "io/model/model.h"
#include "jobs/checks/precision.h"
#include "remesh/schemes/remesh.h"

namespace remesher {

struct PartsRepair {
  std::vector<io::Part> parts;
  RepairReport report;
  std::vector<Warning> warnings;
  bool isRemade = false;  // whether a lattice replaced the triangles of any part
};

// Throws the Errors of repairSurface.
PartsRepair repairParts(std::vector<io::Part> parts, const PartOptions& options,
                        const Progress& progress);

// PARTS_MEET, if triangles of parts intersect those of others, which no repair of a part mends.
std::vector<Warning> warningsOfMeeting(const std::vector<io::Part>& parts);

// ONE_SIDED, if parts of surfaces have one side only.
std::vector<Warning> warningsOfOneSided(const std::vector<io::Part>& parts);

// Whether a surface is closed, a 2-manifold, passes through itself nowhere, and each triangle has
// an area.
bool isSound(const TriangleMesh& mesh);

// The outcome of remeshing the repaired `original`, rounded as by inPrecisionOf. If rounding makes
// it unsound (open, not a 2-manifold or self-intersecting) and the original is sound, the original
// is returned, with a warning.
RoundedMesh inSoundPrecisionOf(const TriangleMesh& original, RemeshOutcome& outcome);

// The faults of all parts: sums, the loops of each part in percent of its own diagonal, and the
// most far-reaching repair.
FaultReport faultsOf(const std::vector<io::Part>& parts);

}  // namespace remesher
