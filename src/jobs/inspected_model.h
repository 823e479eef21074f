// SPDX-License-Identifier: MIT
// Reads and inspects a mesh or a file, and keeps its parts for a closer inspection.
#pragma once

#include <vector>

#include "base/file.h"
#include "base/progress.h"
#include "base/report.h"
#include "base/triangle_mesh.h"
#include "io/model/model.h"

namespace remesher {

enum class Inspection { Brief, Close };  // close: PLACES_JOINED is said, too

struct InspectedModel {
  std::vector<io::Part> parts;  // places that are meant to be one are joined
  Report report;
};

// Throws the Errors of requireValid, and OUT_OF_MEMORY for what has no room in any way.
InspectedModel inspectedMesh(const TriangleMesh& mesh);
// The same, and the Errors of io::read.
InspectedModel inspectedFile(const File& file, const std::vector<File>& resources, Inspection how,
                             const Progress& progress);

}  // namespace remesher
