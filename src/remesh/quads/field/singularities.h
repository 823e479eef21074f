// SPDX-License-Identifier: MIT
// Where crosses do not go on smoothly: vertices inside around which they turn. The index of one is
// the number of quarter turns over 4; the quads' vertex there will have valence 4 − 4 · index.
#pragma once

#include "remesh/quads/field/cross_field.h"

namespace remesher {

// Per vertex four times its index; 0 on boundaries. Over a closed surface the indices add up to
// Euler's characteristic [Poincaré–Hopf].
VertexData<int> quarterIndices(const CrossField& field, const WorkingMesh& mesh,
                               const FaceFrames& frames);

// Takes away pairs of opposite singularities that are no farther from each other than `reach`,
// along edges; the nearest first. No pair is joined across a curve.
void cancelPairs(CrossField& field, const WorkingMesh& mesh, const FaceFrames& frames,
                 double reach);

}  // namespace remesher
