// SPDX-License-Identifier: MIT
// What several parts of a file are like together, for the report.
#pragma once

#include <optional>
#include <vector>

#include "base/report.h"
#include "geometry/triangle_tree.h"
#include "io/model/model.h"
#include "measure/hausdorff.h"
#include "mesh/welding.h"

namespace remesher {

// Throws Error as requireValid does.
std::vector<Welding> weldingsOf(const std::vector<io::Part>& parts);

// Counts add up; shares and means are weighted by what they are shares and means of.
MeshReport inspectParts(const std::vector<io::Part>& parts, const std::vector<Welding>& weldings);

// All parts where they are first shown, beside the first of them, as one bag of triangles without
// those that are lines.
TriangleMesh gathered(const std::vector<io::Part>& parts);

// How far the results are from what is given, one part at least, as gathered. tree: of the only
// part's triangles that are no lines, each once, if one is at hand.
FidelityReport fidelityOf(const std::vector<io::Part>& originals,
                          const std::vector<io::Part>& results, Maximum maximum,
                          std::optional<ListedTree> tree);

// Both lists as one; warnings of the same code become one.
std::vector<Warning> joined(std::vector<Warning> all, const std::vector<Warning>& more);

}  // namespace remesher
