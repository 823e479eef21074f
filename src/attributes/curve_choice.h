// SPDX-License-Identifier: MIT
// Which edges of the original become feature curves: detected, given by the caller, or seams.
#pragma once

#include <vector>

#include "attributes/attribute_transfer.h"
#include "base/options.h"
#include "base/report.h"
#include "base/triangle_mesh.h"
#include "curves/feature_curves.h"
#include "mesh/mesh_builder.h"

namespace remesher {

struct CurveChoice {
  FeatureCurves curves;
  TransferRules transfer;  // for the attributes whose seams are not kept, or not as curves
  std::vector<Warning> warnings;
};

// size: the target edge length, model units.
CurveChoice chooseCurves(const BuiltMesh& built, const TriangleMesh& input,
                         const RemeshOptions& options, double size);

}  // namespace remesher
