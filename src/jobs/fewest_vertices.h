// SPDX-License-Identifier: MIT
// A bound on the distance and no number: as few vertices as the bound allows.
#pragma once

#include "base/options.h"
#include "base/progress.h"
#include "base/report.h"
#include "base/triangle_mesh.h"
#include "mesh/welding.h"
#include "remesh/schemes/remesh.h"

namespace remesher {

// Whether a bound is all that is asked for.
bool asksForFewest(const RemeshOptions& options);

// The number is looked for with drafts, which find it to a tenth; where no draft
// keeps the bound it is the input's own. Throws Error as remeshSurface does.
RemeshOutcome remeshToFewest(const TriangleMesh& input, Welding welding,
                             const RemeshOptions& options, const Progress& progress);

// What levels of detail are shares of: the number found for the finest, if one was looked for, and
// no bound, which fewer do not keep.
RemeshOptions optionsOfLevels(RemeshOptions options, const Report& finest);

}  // namespace remesher
