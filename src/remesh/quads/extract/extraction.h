// SPDX-License-Identifier: MIT
// The quads of a seamless map: one for each unit square of the map. From the middle of a square a
// walk leads to each of its four corners; corners at the same spot of the mesh become one vertex.
#pragma once

#include "remesh/quads/map/seamless_map.h"
#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

// Squares with unreachable corners are left out, so that the quads may be another kind of surface
// than the mesh.
QuadMesh extractQuads(const WorkingMesh& mesh, const SeamlessMap& map);

// Marks the sides that follow the curves: those between neighbours on a chain. Vertices of a chain
// that the quads do not follow from end to end become inner vertices. Returns the number of these
// chains.
std::size_t followCurves(QuadMesh& quads, const WorkingMesh& mesh);

}  // namespace remesher
