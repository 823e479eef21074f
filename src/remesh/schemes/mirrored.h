// SPDX-License-Identifier: MIT
// Quads of a model that planes mirror: made on one side, mirrored to the others.
#pragma once

#include <functional>
#include <optional>

#include "remesh/schemes/remesh.h"

namespace remesher {

// Makes quads of a half, with its boundary along the planes: see RemeshOptions::mirrors.
using HalfRemesher =
    std::function<RemeshOutcome(const TriangleMesh& half, const RemeshOptions& options)>;

// Mirrored by as many planes as possible. None if no plane mirrors the input, if seams, borders of
// materials or the caller's own wishes for places are not mirrored, if the exact number or the
// surface's kind cannot be had so, or if another number takes single quads out.
std::optional<RemeshOutcome> remeshMirrored(const TriangleMesh& input, const RemeshOptions& options,
                                            const HalfRemesher& remeshHalf);

}  // namespace remesher
