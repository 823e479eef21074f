// SPDX-License-Identifier: MIT
// The remesher as one function: build, original surface, scheme, result.
#pragma once

#include "base/options.h"
#include "base/progress.h"
#include "base/report.h"
#include "base/triangle_mesh.h"

namespace remesher {

struct RemeshOutcome {
  TriangleMesh
      mesh;  // vertices in as many copies as their attributes need; positions distinct otherwise
  double buildMilliseconds = 0;  // to mend the input and prepare the original surface
  Stopped stopped = Stopped::Target;
  std::vector<Warning> warnings;
};

// Throws Error as buildMesh does, and INVALID_OPTION, TARGET_TOO_SMALL, TARGET_BELOW_CURVES,
// CANCELLED.
RemeshOutcome remeshSurface(const TriangleMesh& input, const RemeshOptions& options,
                            const Progress& progress);

}  // namespace remesher
