// SPDX-License-Identifier: MIT
// Joins vertices of a file's parts before any other step.
#pragma once

#include <optional>
#include <vector>

#include "base/report.h"
#include "io/model/model.h"

namespace remesher {

// Removes noise around zero, and joins places nearer than `percent` of a part's diagonal. Throws
// the Errors of requireValid.
std::vector<io::Part> joinedPlaces(std::vector<io::Part> parts, std::optional<double> percent);

// TRIANGLES_NOT_JOINED if no triangle of any part shares an edge with another; says what would join
// them.
std::vector<Warning> looseTriangles(const MeshReport& report, const std::vector<io::Part>& parts);

}  // namespace remesher
