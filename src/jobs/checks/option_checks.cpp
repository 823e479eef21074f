// SPDX-License-Identifier: MIT
#include "jobs/checks/option_checks.h"

#include "base/error.h"
#include "jobs/checks/wanted_check.h"

namespace remesher {

namespace {

bool excludesConform(const RemeshOptions& options) {
  const bool isByNumbers =
      !options.density.empty() || !options.featureEdges.empty() || !options.region.empty();
  const bool isOtherMesh = options.quads || options.prefer == Prefer::Shape ||
                           options.scheme == Scheme::Rounds || options.splitObtuse ||
                           options.boundary == Boundary::Keep;
  return options.repair != Repair::Off || options.unite || options.dropHidden ||
         !options.lods.empty() || options.textures == Textures::Keep ||
         options.textures == Textures::Bake || isByNumbers || isOtherMesh;
}

}  // namespace

void checkTogether(const RemeshOptions& options) {
  const bool namesVertices = !options.density.empty() || !options.featureEdges.empty();
  if (options.repair != Repair::Off && namesVertices)
    throw Error(ErrorCode::InvalidOption,
                "density and featureEdges number the input's vertices, and repair makes others.",
                "Repair the mesh first, then remesh the result.");
  if (options.conform && excludesConform(options))
    throw Error(ErrorCode::InvalidOption,
                "conform remeshes closed bodies together, as isotropic triangles of one level "
                "without textures: it excludes repair, quads, prefer: shape, rounds, splitObtuse, "
                "kept boundaries and textures, lods, unite, dropHidden, density, featureEdges and "
                "region.",
                "Leave out conform, or these.");
  checkWanted(options);
}

}  // namespace remesher
