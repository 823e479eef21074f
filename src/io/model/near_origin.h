// SPDX-License-Identifier: MIT
// Models far from the origin, as maps and surveys have them: single precision would cost their
// shape.
#pragma once

#include "io/model/model.h"

namespace remesher::io {

// Whether single precision moves vertices by a visible part of the model.
bool isFarFromOrigin(const TriangleMesh& mesh);

// The part at the origin, its instances taking it back. Their translation has few digits: viewers
// round it to single precision.
void moveToOrigin(Part& part);

}  // namespace remesher::io
