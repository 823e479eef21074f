// SPDX-License-Identifier: MIT
// Collapses where every one that the gate allows counts: in the middle of the edge, else into
// either of its ends.
#pragma once

#include "schemes/run.h"

namespace remesher {

// The shortest edges, relative to their targets, until no more than `vertices` are left or nothing
// more goes. What was refused is asked again only when something around it has changed.
void coarsen(Run& run, std::size_t vertices);

}  // namespace remesher
