// SPDX-License-Identifier: MIT
// What several parts of a file are like together, for the report.
#pragma once

#include <vector>

#include "base/report.h"
#include "io/model/model.h"
#include "soup/welding.h"

namespace remesher {

// Throws Error as requireValid does.
std::vector<Welding> weldingsOf(const std::vector<io::Part>& parts);

// Counts add up; shares and means are weighted by what they are shares and means of.
MeshReport inspectParts(const std::vector<io::Part>& parts, const std::vector<Welding>& weldings);

// All parts where they are first shown, beside the first of them, as one bag of triangles without
// those that are lines.
TriangleMesh gathered(const std::vector<io::Part>& parts);

// Both lists as one; warnings of the same code become one.
std::vector<Warning> joined(std::vector<Warning> all, const std::vector<Warning>& more);

}  // namespace remesher
