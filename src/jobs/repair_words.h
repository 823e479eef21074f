// SPDX-License-Identifier: MIT
// Reports and warnings of several repairs as one.
#pragma once

#include <vector>

#include "base/report.h"
#include "io/model/model.h"
#include "repair/repair.h"

namespace remesher {

// Adds up the counts.
void add(RepairReport& sum, const RepairReport& part);

// Warnings of the same code are merged, at the first place.
void join(std::vector<PlacedWarning>& all, PlacedWarning warning);

// The warnings with their places in the world in words.
std::vector<Warning> inWords(std::vector<PlacedWarning> warnings,
                             const std::vector<io::Part>& parts);

}  // namespace remesher
