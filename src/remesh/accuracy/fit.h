// SPDX-License-Identifier: MIT
// A late step of `best`: a mesh whose vertices all lie on a curved surface leaves its triangles
// on the inner side. Moving vertices along their normals to the local least-squares fit of the
// original about halves the RMS error at no cost in quality. Their places on the original, and with
// them all attributes, stay.
#pragma once

#include "remesh/steps/run.h"

namespace remesher {

// Interior vertices only. No move opens a bad triangle.
void fit(Run& run, const Progress& progress);

}  // namespace remesher
