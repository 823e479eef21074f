// SPDX-License-Identifier: MIT
// Whether memory has room for a repair, or for the search for faults, which takes as much: told by
// the numbers of triangles alone, before any work.
#pragma once

#include <optional>
#include <vector>

#include "base/report.h"
#include "base/room.h"
#include "io/model/model.h"

namespace remesher {

// Throws OUT_OF_MEMORY if the parts have no room to be repaired.
void requireRoomToRepair(const std::vector<io::Part>& parts, double addresses = kAddresses);

// FAULTS_NOT_SOUGHT if the parts have no room for the search.
std::optional<Warning> noRoomForFaults(const std::vector<io::Part>& parts,
                                       double addresses = kAddresses);

}  // namespace remesher
