// SPDX-License-Identifier: MIT
// What several parts of a file are like together, for the report.
#pragma once

#include <vector>

#include "base/report.h"
#include "io/model/model.h"

namespace remesher {

// Counts add up; shares and means are weighted by what they are shares and means of.
// Throws Error as requireValid does.
MeshReport inspectParts(const std::vector<io::Part>& parts);

// All parts where they are first shown, beside the first of them, as one bag of triangles without
// those that are lines.
TriangleMesh gathered(const std::vector<io::Part>& parts);

// Both lists as one; warnings of the same code become one.
std::vector<Warning> joined(std::vector<Warning> all, const std::vector<Warning>& more);

}  // namespace remesher
