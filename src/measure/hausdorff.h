// SPDX-License-Identifier: MIT
// How far two surfaces are apart, measured from points of each to the other: from every vertex, and
// from points spread evenly by area. Points are set denser where the distance is largest. If a
// bound is wanted instead of an estimate, triangles are subdivided until it is proven.
//
// Most points are nearer than the largest distance already known, which is cheap to find out. Only
// the points spread by area, from which the rms is computed, are measured exactly.
#pragma once

#include <algorithm>
#include <optional>

#include "base/report.h"
#include "base/triangle_mesh.h"
#include "geometry/triangle_tree.h"

namespace remesher {

// Glimpsed: from a few thousand points of the original, spread by area, and from a quarter as many
// of its vertices, the most salient; not from the result, so that missing parts are seen but parts
// that jut out are not. Sampled: from all the points above; seldom more than a percent too small,
// with an rms within about two percent. Proven: no distance is more than 0.2 % larger, or 0.001 %
// of the diagonal, at many times the cost, with an rms from four times the points.
enum class Maximum { Glimpsed, Sampled, Proven };

// Distances from the points of one surface to the other surface, in model units.
struct Deviation {
  double maximum = 0;
  double rms = 0;  // root of the mean square over the area
};

struct DeviationBothWays {
  Deviation toResult;    // from the original
  Deviation toOriginal;  // from the result
  double diagonal = 0;   // of the original's bounding box

  double maximum() const { return std::max(toResult.maximum, toOriginal.maximum); }
};

// Both meshes need a triangle, valid indices and finite coordinates. tree: if at hand, over the
// original's positions and all its triangles that have an area, each once.
DeviationBothWays measureDeviation(const TriangleMesh& original, const TriangleMesh& result,
                                   Maximum maximum, std::optional<ListedTree> tree = {});

// The larger value of the two directions, in percent of the original's diagonal.
FidelityReport measureFidelity(const TriangleMesh& original, const TriangleMesh& result,
                               Maximum maximum = Maximum::Sampled,
                               std::optional<ListedTree> tree = {});

}  // namespace remesher
