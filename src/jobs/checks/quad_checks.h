// SPDX-License-Identifier: MIT
// Finds faults of finished quads that no step before looks for; warnings say where they are.
#pragma once

#include <vector>

#include "base/report.h"
#include "io/model/model.h"

namespace remesher {

// QUADS_OFF_BORDER for parts of quads whose open edges do not lie on the open edges given, or that
// have fewer open loops. The parts given come in the order of the result's.
std::vector<Warning> bordersOffGiven(const std::vector<io::Part>& given,
                                     const std::vector<io::Part>& result);

// QUADS_TOO_FEW where the part given is farther from its quads than 0.6 of their mean side.
std::vector<Warning> lostToQuads(const std::vector<io::Part>& given,
                                 const std::vector<io::Part>& result);

// QUADS_TURNED_AWAY for quads that face away from all of the part given that is near them.
std::vector<Warning> turnedFromGiven(const std::vector<io::Part>& given,
                                     const std::vector<io::Part>& result);

// QUADS_PAIRED for the connected parts without a map to squares.
std::vector<Warning> pairedParts(const QuadReport& quads, const std::vector<io::Part>& result);

}  // namespace remesher
