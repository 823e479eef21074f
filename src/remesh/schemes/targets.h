// SPDX-License-Identifier: MIT
// How many vertices a run is to reach, and whether what the caller wishes can be had at all.
#pragma once

#include "base/error.h"
#include "base/options.h"
#include "mesh/mesh_builder.h"
#include "original/curves/feature_curves.h"
#include "original/surface/size_field.h"

namespace remesher {

// TARGET_TOO_SMALL, TARGET_BELOW_CURVES: fewer vertices than a surface needs.
struct VertexNeeds {
  std::size_t target;  // asked for
  std::size_t needed;  // what is fewer is refused
  std::size_t enough;  // what can be reached, as far as anybody knows
};
struct TooFewVertices : Error, VertexNeeds {
  TooFewVertices(ErrorCode errorCode, const VertexNeeds& needs);
};

// Throws INVALID_OPTION for values out of range and for lists that do not fit the input.
void checkOptions(const RemeshOptions& options, std::size_t inputVertices);

// Throws NO_TRIANGLES when there is none.
double surfaceArea(const BuiltMesh& built);

// From vertices, ratio or edgeLength, else the input's own number. What is fewer than the surface
// needs is raised or refused with TARGET_TOO_SMALL, as the options say; throws OUT_OF_MEMORY for
// what could never be held.
std::size_t targetVertices(const BuiltMesh& built, const RemeshOptions& options);

// As many of the original's vertices are corners of curves, which never move.
std::size_t countCorners(const FeatureCurves& curves, const HalfedgeMesh& mesh);

// Throws TARGET_BELOW_CURVES when there are more corners than vertices.
void checkCurves(std::size_t corners, std::size_t vertices);

// What the sizes follow. `density` is per vertex of the original and must outlive the rules.
SizeRules sizeRules(const RemeshOptions& options, double vertices, std::span<const float> density);

// The caller's density, per input vertex, for each vertex of the original.
std::vector<float> densityOf(const BuiltMesh& built, const RemeshOptions& options);

}  // namespace remesher
