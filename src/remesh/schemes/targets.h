// SPDX-License-Identifier: MIT
// The target number of vertices, and checks whether the caller's wishes can be met at all.
#pragma once

#include "base/error.h"
#include "base/part_options.h"
#include "mesh/mesh_builder.h"
#include "original/curves/feature_curves.h"
#include "original/surface/size_field.h"

namespace remesher {

// TARGET_TOO_SMALL, TARGET_BELOW_CURVES: fewer vertices than a surface needs.
struct VertexNeeds {
  std::size_t target;  // asked for
  std::size_t needed;  // a smaller target is refused
  std::size_t enough;  // a target that can be reached, as far as is known
};
struct TooFewVertices : Error, VertexNeeds {
  TooFewVertices(ErrorCode errorCode, const VertexNeeds& needs);
};

// How many vertices the topology of a surface asks for; as VertexNeeds.
struct Fewest {
  std::size_t needed = 0, enough = 0;
};
Fewest fewestVertices(const HalfedgeMesh& mesh);

// Throws INVALID_OPTION for values out of range and for lists that do not fit the input.
void checkOptions(const PartOptions& options, std::size_t inputVertices);

// Throws NO_TRIANGLES when there is none.
double surfaceArea(const BuiltMesh& built);

struct ModelSize {
  double vertices, triangles;
};

// Throws OUT_OF_MEMORY for a model, or a target in vertices, for which `addresses` bytes have no
// room, with the numbers that they would have room for.
void requireRoom(const ModelSize& model, double target, double addresses);

// From vertices, ratio or edgeLength, else the input's own number. A target below the surface's
// need is raised or refused with TARGET_TOO_SMALL, as the options say. Throws OUT_OF_MEMORY for a
// target that no memory could hold.
std::size_t targetVertices(const BuiltMesh& built, const PartOptions& options);

// The number of the original's vertices that are corners of curves; they never move.
std::size_t countCorners(const FeatureCurves& curves, const HalfedgeMesh& mesh);

// Throws TARGET_BELOW_CURVES when there are more corners than vertices.
void checkCurves(std::size_t corners, std::size_t vertices);

// The rules that the sizes follow. `density` is per vertex of the original and must outlive the
// rules.
SizeRules sizeRules(const PartOptions& options, double vertices, std::span<const float> density);

// The caller's density, per input vertex, for each vertex of the original.
std::vector<float> densityOf(const BuiltMesh& built, const PartOptions& options);

}  // namespace remesher
