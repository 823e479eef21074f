// SPDX-License-Identifier: MIT
// How far two surfaces are apart, by looking from points of each to the other: from every vertex,
// and from points spread evenly by area. Where the distance is largest the points are set denser;
// where a bound is wanted and not an estimate, triangles are subdivided until it is proven.
//
// Most points are nearer than what is known to be the largest distance, and it costs little to see
// that: only the points spread by area, which the rms is made of, are measured to the end.
#pragma once

#include <optional>

#include "base/report.h"
#include "base/triangle_mesh.h"
#include "geometry/triangle_tree.h"

namespace remesher {

// Glimpsed: from a few thousand points of the original, spread by area, and a quarter as many of
// its vertices, those that stand out most, and no way back: what the result lacks is seen, what
// juts out of it is not. Sampled: from all the points above; it is seldom more than a percent too
// small, and the rms within about two percent. Proven: none is more than 0.2 % larger, or 0.001 %
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
};

// Both meshes need a triangle, valid indices and finite coordinates. tree: over the original's
// positions, of all its triangles that have an area, each once, if one is at hand.
DeviationBothWays measureDeviation(const TriangleMesh& original, const TriangleMesh& result,
                                   Maximum maximum, std::optional<ListedTree> tree = {});

// The larger of both directions, in percent of the original's diagonal.
FidelityReport measureFidelity(const TriangleMesh& original, const TriangleMesh& result,
                               Maximum maximum = Maximum::Sampled,
                               std::optional<ListedTree> tree = {});

}  // namespace remesher
