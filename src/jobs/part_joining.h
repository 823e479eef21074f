// SPDX-License-Identifier: MIT
// What is to be joined in the parts of a file before anything else is done.
#pragma once

#include <optional>
#include <vector>

#include "base/report.h"
#include "io/model/model.h"

namespace remesher {

// Noise around zero goes; places nearer than `percent` of a part's diagonal become one. Throws
// Error as requireValid does.
std::vector<io::Part> joinedPlaces(std::vector<io::Part> parts, std::optional<double> percent);

// TRIANGLES_NOT_JOINED where no triangle of all parts shares an edge with another, and what would
// join them.
std::vector<Warning> looseTriangles(const MeshReport& report, const std::vector<io::Part>& parts);

}  // namespace remesher
