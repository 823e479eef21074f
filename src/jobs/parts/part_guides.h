// SPDX-License-Identifier: MIT
// Guides, which lie in the world, shared out among the surfaces of a scene. The engine for arrays
// lacks it.
#pragma once

#include <vector>

#include "base/part_options.h"
#include "base/report.h"
#include "io/model/model.h"

namespace remesher {

struct SharedGuides {
  std::vector<std::vector<Guide>> ofSurface;  // in its own space; empty without guides
  std::vector<Warning> warnings;              // on guides that are far from all surfaces
};

// Each guide goes to the surface that is nearest at one of its places. Throws INVALID_OPTION if no
// quads are asked for.
SharedGuides sharedGuides(const std::vector<io::Part>& surfaces, const PartOptions& options);

}  // namespace remesher
