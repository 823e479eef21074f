// SPDX-License-Identifier: MIT
// Singularities of the cross field: inner vertices around which the crosses turn. The index of a
// singularity is the number of quarter turns divided by 4; the quads' vertex there will have
// valence 4 − 4 · index.
#pragma once

#include "base/patience.h"
#include "remesh/quads/field/cross_field.h"

namespace remesher {

// Per vertex four times its index; 0 on boundaries. Over a closed surface the indices add up to
// Euler's characteristic [Poincaré–Hopf].
VertexData<int> quarterIndices(const CrossField& field, const WorkingMesh& mesh,
                               const FaceFrames& frames);

// Cancels pairs of opposite singularities at most `reach` apart along edges, the nearest pairs
// first. No pair is cancelled across a curve. Of a soup, singularities are so many that work ends.
void cancelPairs(CrossField& field, const WorkingMesh& mesh, const FaceFrames& frames, double reach,
                 WorkBudget& work);

// A field for quads with sides of this length, its nearest pairs cancelled.
CrossField makeSmoothField(const WorkingMesh& mesh, const FaceFrames& frames, double length,
                           WorkBudget& work, const FieldWishes& wishes = {});

}  // namespace remesher
