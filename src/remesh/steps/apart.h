// SPDX-License-Identifier: MIT
// Vertices that lie on each other though their stars do not: where sheets of the surface touch.
#pragma once

#include "remesh/steps/run.h"

namespace remesher {

// What is written alike is one vertex in a file, and sheets that share two of them are grown
// together. Of the vertices that are written at one place all but one go a small way into a
// triangle of theirs, if the gate lets them and they are on no curve. Those of boundaries go along
// them, where they lie on a corner of one or edges inside lie on each other. Returns how many still
// lie where others do, but for boundaries that do so side by side.
std::size_t moveApart(Run& run);

}  // namespace remesher
