// SPDX-License-Identifier: MIT
// Handles models far from the origin, such as maps and surveys: single precision would lose their
// shape.
#pragma once

#include "io/model/model.h"

namespace remesher::io {

// Whether single precision moves vertices by a visible share of the model's size.
bool isFarFromOrigin(const TriangleMesh& mesh);

// The steps in which single precision tells the mesh's farthest coordinates apart.
double singleStep(const TriangleMesh& mesh);

// Moves a part to the origin; its instances move it back. Their translation has few digits, because
// viewers round it to single precision.
void moveToOrigin(Part& part);

}  // namespace remesher::io
