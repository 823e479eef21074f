// SPDX-License-Identifier: MIT
// Which edges of the original become feature curves: detected, given by the caller, or seams.
#pragma once

#include <string>
#include <vector>

#include "base/options.h"
#include "base/report.h"
#include "base/triangle_mesh.h"
#include "curves/feature_curves.h"
#include "mesh/mesh_builder.h"

namespace remesher {

struct CurveChoice {
  FeatureCurves curves;
  std::vector<std::string> chartless;  // attributes whose seams are not kept: see findSeams
  std::vector<Halfedge> jumps;         // the seams that texture must not bleed over, kept or not
  FaceData<char> absorbed;             // see SimplifiedCurves
  std::vector<Warning> warnings;
};

// size: the target edge length, model units.
CurveChoice chooseCurves(const BuiltMesh& built, const TriangleMesh& input,
                         const RemeshOptions& options, double size);

}  // namespace remesher
