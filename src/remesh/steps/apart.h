// SPDX-License-Identifier: MIT
// Separates coincident vertices of different sheets, where the surface touches itself.
#pragma once

#include "remesh/steps/run.h"

namespace remesher {

// A file joins vertices that are written alike, and sheets that share two of them grow together. Of
// the vertices written at one place all but one move a small way into one of their triangles, if
// the gate lets them and they are on no curve. Boundary vertices move along their boundary if they
// lie on a vertex that may not move, or if inner edges coincide. Returns how many still coincide
// with others, without those of boundaries that lie side by side.
std::size_t moveApart(Run& run);

}  // namespace remesher
