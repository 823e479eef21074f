// SPDX-License-Identifier: MIT
// Which edges of the original become feature curves: detected, given by the caller, or seams.
#pragma once

#include "base/options.h"
#include "base/report.h"
#include "base/triangle_mesh.h"
#include "mesh/mesh_builder.h"
#include "surface/feature_curves.h"

namespace remesher {

// size: the target edge length, model units. Adds to `warnings` what seams cannot be kept.
FeatureCurves chooseCurves(const BuiltMesh& built, const TriangleMesh& input,
                           const RemeshOptions& options, double size,
                           std::vector<Warning>& warnings);

}  // namespace remesher
