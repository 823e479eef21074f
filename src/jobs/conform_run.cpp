// SPDX-License-Identifier: MIT
#include "jobs/conform_run.h"

#include <utility>

#include "base/error.h"
#include "jobs/touching_parts.h"

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

ConformRun::ConformRun(const std::vector<io::Part>& given, const RemeshOptions& options)
    : parts_(&given) {
  if (!options.conform) return;
  if (excludesConform(options))
    throw Error(ErrorCode::InvalidOption,
                "conform remeshes closed bodies together, as isotropic triangles of one level "
                "without textures: it excludes repair, quads, prefer: shape, rounds, splitObtuse, "
                "kept boundaries and textures, lods, unite, dropHidden, density, featureEdges and "
                "region.",
                "Leave out conform, or these.");
  touching_ = std::make_shared<const TouchingParts>(given, options);
  parts_ = &touching_->parts();
}

RemeshOptions ConformRun::applied(RemeshOptions options) const {
  return touching_ ? touching_->applied(std::move(options)) : options;
}

void ConformRun::finish(std::vector<SceneRun>& runs) const {
  if (touching_) touching_->finish(runs);
}

}  // namespace remesher
