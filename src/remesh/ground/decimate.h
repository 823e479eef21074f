// SPDX-License-Identifier: MIT
// Thins out a mesh that is much finer than wanted. Vertices collapse into neighbours, which stay in
// place: nothing is projected, smoothed or sorted. A pass removes at most one vertex of each star,
// and edges grow evenly from pass to pass, so that valences stay small and triangles sound.
#pragma once

#include "remesh/gate/fidelity.h"

namespace remesher {

// Collapses edges until they are about as long as `spacing`, per vertex, asks for; not where the
// surface bends more than such edges could follow, nor on curves. Compacts the mesh in the end.
// Returns the collapse map: per former vertex the new number of the vertex that it was collapsed
// into, or its own.
VertexData<Vertex> decimate(WorkingMesh& mesh, const FidelityRule& rule,
                            const VertexData<double>& spacing);

}  // namespace remesher
