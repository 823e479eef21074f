// SPDX-License-Identifier: MIT
// Thins out a mesh that is much finer than it is to be. Vertices go into neighbours, which stay
// where they are: nothing is projected, smoothed or sorted. Of each star one vertex goes in a pass,
// and edges grow evenly from pass to pass, so that valences stay small and triangles sound.
#pragma once

#include "remesh/gate/fidelity.h"

namespace remesher {

// Until edges are about as long as `spacing`, per vertex, asks for; not where the surface bends
// more than such edges could follow, nor on curves. Closes the holes in the end. Returns the heir,
// by its new number, of each vertex that there was: itself, or what it has gone into. The pass that
// takes no more than the share `worthwhile` of the vertices is the last one.
VertexData<Vertex> decimate(WorkingMesh& mesh, const FidelityRule& rule,
                            const VertexData<double>& spacing, double worthwhile = 0.02);

}  // namespace remesher
