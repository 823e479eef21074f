// SPDX-License-Identifier: MIT
// What several parts of a file are like together, for the report.
#pragma once

#include <optional>
#include <vector>

#include "base/report.h"
#include "geometry/triangle_tree.h"
#include "io/model/model.h"
#include "jobs/part_places.h"
#include "measure/hausdorff.h"
#include "mesh/welding.h"

namespace remesher {

// Throws Error as requireValid does.
std::vector<Welding> weldingsOf(const std::vector<io::Part>& parts);

// Of each part as it looks at its place, but for coarser levels of detail. Counts add up; shares
// and means are weighted by what they are shares and means of.
MeshReport inspectParts(const std::vector<io::Part>& parts, const std::vector<Welding>& weldings,
                        const std::vector<PartPlace>& places);

// All parts at their places, beside the first of them, as one bag of triangles without those that
// are lines.
TriangleMesh gathered(const std::vector<io::Part>& parts, const std::vector<PartPlace>& places);

// What is given, one part at least, and what was made of it.
struct PartPairs {
  const std::vector<io::Part>& originals;
  const std::vector<io::Part>& results;
  const std::vector<PartPlace>& places;
};

// How far the results are from what is given, as gathered. tree: of the only part's triangles that
// are no lines, each once, if one is at hand.
FidelityReport fidelityOf(const PartPairs& parts, Maximum maximum, std::optional<ListedTree> tree);

// Both lists as one; warnings of the same code become one.
std::vector<Warning> joined(std::vector<Warning> all, const std::vector<Warning>& more);

}  // namespace remesher
