// SPDX-License-Identifier: MIT
// How many vertices a run is to reach, and whether what the caller wishes can be had at all.
#pragma once

#include "base/options.h"
#include "mesh/mesh_builder.h"
#include "surface/feature_curves.h"
#include "surface/size_field.h"

namespace remesher {

// Throws INVALID_OPTION for values out of range and for lists that do not fit the input.
void checkOptions(const RemeshOptions& options, std::size_t inputVertices);

// Throws NO_TRIANGLES when there is none.
double surfaceArea(const BuiltMesh& built);

// From vertices, ratio or edgeLength, else the input's own number. Throws TARGET_TOO_SMALL, and
// OUT_OF_MEMORY for what could never be held.
std::size_t targetVertices(const BuiltMesh& built, const RemeshOptions& options);

// Throws TARGET_BELOW_CURVES when there are more corners, which never move, than the target allows.
void checkCurves(const FeatureCurves& curves, const HalfedgeMesh& mesh, std::size_t vertices);

// What the sizes follow. `density` is per vertex of the original and must outlive the rules.
SizeRules sizeRules(const RemeshOptions& options, double vertices, std::span<const float> density);

// The caller's density, per input vertex, for each vertex of the original.
std::vector<float> densityOf(const BuiltMesh& built, const RemeshOptions& options);

}  // namespace remesher
