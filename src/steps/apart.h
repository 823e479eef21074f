// SPDX-License-Identifier: MIT
// Vertices that lie on each other though their stars do not: where sheets of the surface touch.
#pragma once

#include "steps/run.h"

namespace remesher {

// What is written alike is one vertex in a file, and sheets that share two of them are grown
// together. Of the vertices that are written at one place all but one go a small way into a
// triangle of theirs, if the gate lets them. Those of curves stay, for along boundaries the surface
// may have been cut apart that is to be joined again.
void moveApart(Run& run);

}  // namespace remesher
