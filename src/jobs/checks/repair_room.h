// SPDX-License-Identifier: MIT
// Whether memory has room for a repair, or for the search for faults, which takes as much, and for
// what is made of two models: from the numbers of triangles alone, before any work.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/report.h"
#include "base/room.h"
#include "io/model/model.h"

namespace remesher {

// Throws OUT_OF_MEMORY if the parts have no room to be repaired.
void requireRoomToRepair(const std::vector<io::Part>& parts, double addresses = kAddresses);

// Peak memory of a Boolean for each triangle of both operands; of a baking for each of the model
// that is painted from, and of the other, which may have to be unwrapped.
inline constexpr double kCombineBytes = 600, kBakeBytes = 350, kUnwrapBytes = 600;

// Throws OUT_OF_MEMORY if there is no room for the work on two models that the verb names.
void requireRoomForTwo(const RoomNeeds& needs, const std::string& verb,
                       double addresses = kAddresses);

// FAULTS_NOT_SOUGHT if the parts have no room for the search.
std::optional<Warning> noRoomForFaults(const std::vector<io::Part>& parts,
                                       double addresses = kAddresses);

}  // namespace remesher
