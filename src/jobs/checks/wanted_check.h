// SPDX-License-Identifier: MIT
// What came of the limits wanted of every edge and triangle, measured on the result as it is
// written, and warnings where they could not be kept.
#pragma once

#include <optional>
#include <vector>

#include "base/options.h"
#include "base/report.h"
#include "base/unmet.h"
#include "io/model/model.h"

namespace remesher {

// Throws INVALID_OPTION for limits out of range, or that contradict each other.
void checkWanted(const RemeshOptions& options);

// Of a mesh by itself.
WantedReport wantedOf(const TriangleMesh& mesh, const RemeshOptions& options);

// Lengths are measured in the world, each part at its place. None if nothing was wanted.
std::optional<WantedReport> wantedOf(const std::vector<io::Part>& result,
                                     const RemeshOptions& options);

// EDGES_TOO_SHORT, EDGES_TOO_LONG, ANGLES_TOO_SMALL, each with the worst place and, as far as it is
// known, the reason. The report's output has been measured. unmet: what the run knows.
std::vector<Warning> wantedMissed(const MeshReport& output, const std::vector<io::Part>& result,
                                  const RemeshOptions& options, const Unmet& unmet);

}  // namespace remesher
