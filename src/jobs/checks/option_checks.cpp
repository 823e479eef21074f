// SPDX-License-Identifier: MIT
#include "jobs/checks/option_checks.h"

#include "base/error.h"
#include "jobs/checks/wanted_check.h"

namespace remesher {

void checkTogether(const RemeshOptions& options) {
  const bool namesVertices = !options.density.empty() || !options.featureEdges.empty();
  if (options.repair != Repair::Off && namesVertices)
    throw Error(ErrorCode::InvalidOption,
                "density and featureEdges number the input's vertices, and repair makes others.",
                "Repair the mesh first, then remesh the result.");
  checkWanted(options);
}

}  // namespace remesher
