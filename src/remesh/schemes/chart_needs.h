// SPDX-License-Identifier: MIT
// How many vertices a mesh needs to keep its charts. Where edges are too long for a chart, curve
// simplification releases the chart, and the texture's content there is lost.
#pragma once

#include <vector>

#include "base/part_options.h"
#include "base/triangle_mesh.h"

namespace remesher {

struct ChartNeed {
  double width;     // model units; for a border, its length
  double vertices;  // of a uniform mesh of the whole surface that keeps it
};

// One need for each region between curves whose neighbour shows other attribute values, and one for
// each piece of such a border between two junctions. Neighbours on the same place of a texture show
// the same: there nothing can be lost. Empty if no attribute jumps. Throws Error as buildMesh does.
std::vector<ChartNeed> chartNeeds(const TriangleMesh& input, const PartOptions& options);

}  // namespace remesher
