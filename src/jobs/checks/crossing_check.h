// SPDX-License-Identifier: MIT
// Finds self-intersections that a run has made.
#pragma once

#include <optional>
#include <vector>

#include "base/report.h"
#include "base/triangle_mesh.h"
#include "jobs/parts/part_report.h"

namespace remesher {

// The triangles of a result that meet others, beyond the places where triangles of the original do,
// ascending. If the result intersects itself nowhere, the original is not looked at; else
// isCrossed, if given, gets whether the original does.
std::vector<Index> crossingsMade(const TriangleMesh& original, const TriangleMesh& result,
                                 bool* isCrossed = nullptr);

// A vertex of a triangle that intersects another where none of the originals does, and how many
// such triangles there are.
struct MadeCrossings {
  std::size_t count = 0;
  std::size_t part = 0;
  Index vertex = 0;  // of that part's result
};

// own: per part its triangles that meet others of the same part; see crossingsMade. Looks for
// triangles that meet those of other parts, at the places where the parts are shown.
MadeCrossings crossingsMade(const PartPairs& parts, const std::vector<std::vector<Index>>& own);

// SELF_INTERSECTIONS_MADE, if there are any. result: the parts in their own spaces.
std::vector<Warning> warningsOf(const MadeCrossings& made, const std::vector<io::Part>& result);

}  // namespace remesher
