// SPDX-License-Identifier: MIT
#include "jobs/checks/option_checks.h"

#include "base/error.h"
#include "base/legible.h"

namespace remesher {

namespace {

constexpr int kShown = 6;  // digits

}  // namespace

void checkTogether(const RemeshOptions& options) {
  const bool namesVertices = !options.density.empty() || !options.featureEdges.empty();
  if (options.repair != Repair::Off && namesVertices)
    throw Error(ErrorCode::InvalidOption,
                "density and featureEdges number the input's vertices, and repair makes others.",
                "Repair the mesh first, then remesh the result.");
  if (wantsOfEach(options) && (options.quads || options.scheme == Scheme::Rounds ||
                               options.prefer == Prefer::Shape || options.splitObtuse))
    throw Error(
        ErrorCode::InvalidOption,
        "minEdge, maxEdge and minAngle are wanted of isotropic triangles of the scheme best, "
        "not of quads, rounds, prefer: shape or splitObtuse.",
        "Leave out one of them.");
  if (options.minEdge && options.maxEdge && *options.minEdge > *options.maxEdge)
    throw Error(ErrorCode::InvalidOption,
                "minEdge is " + inDigits(*options.minEdge, kShown) + ", longer than maxEdge, " +
                    inDigits(*options.maxEdge, kShown) + ".",
                "Leave room between them: maxEdge at least twice minEdge.");
}

}  // namespace remesher
