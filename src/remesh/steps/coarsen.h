// SPDX-License-Identifier: MIT
// Collapses, the shortest edges first, until few enough vertices are left.
#pragma once

#include "remesh/steps/run.h"

namespace remesher {

// Where the two ends of an edge may meet: the middle keeps vertices evenly spread; the ends
// themselves are for when every collapse that the gate allows counts.
enum class MeetingPlace { Middle, MiddleOrEnds };

// Collapses the shortest edges, relative to their targets, until no more than `vertices` are left
// or no collapse succeeds. A refused edge is tried again only after a change around it.
void coarsen(Run& run, std::size_t vertices, MeetingPlace place, const Progress& progress = {});

}  // namespace remesher
