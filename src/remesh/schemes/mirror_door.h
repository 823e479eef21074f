// SPDX-License-Identifier: MIT
// The way to remeshMirrored, which the engine for arrays lacks, and which is compiled for size.
#pragma once

#include "remesh/schemes/mirrored.h"

namespace remesher {

// None in the engine for arrays, which makes no quads.
std::optional<RemeshOutcome> remeshIfMirrored(const TriangleMesh& input,
                                              const RemeshOptions& options,
                                              const HalfRemesher& remeshHalf);

}  // namespace remesher
