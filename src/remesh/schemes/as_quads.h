// SPDX-License-Identifier: MIT
// Quads of surfaces that have several parts, or that planes mirror. The engine for arrays lacks it.
#pragma once

#include "remesh/schemes/mirrored.h"

namespace remesher {

// Each connected part is made for itself, and where planes mirror it, or the caller wants it
// mirrored, on one side of the planes only. plain: makes quads of a surface as it is. Throws what
// it throws, and INVALID_OPTION, TARGET_TOO_SMALL.
RemeshOutcome remeshAsQuads(const TriangleMesh& input, const Welding& welding,
                            const PartOptions& options, const PlainRemesher& plain,
                            const Progress& progress);

}  // namespace remesher
