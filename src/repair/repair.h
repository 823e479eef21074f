// SPDX-License-Identifier: MIT
// A surface mended before anything else is done with it.
#pragma once

#include <vector>

#include "base/options.h"
#include "base/report.h"
#include "base/triangle_mesh.h"

namespace remesher {

struct RepairedMesh {
  TriangleMesh mesh;
  RepairReport report;
  std::vector<Warning> warnings;
};

// As the options' repair, holesUpTo and gap say. Throws Error as requireValid does, NO_TRIANGLES if
// nothing can be kept.
RepairedMesh repairSurface(const TriangleMesh& input, const RemeshOptions& options);

// What is broken. Throws Error as buildMesh does.
FaultReport faultsOf(const TriangleMesh& input);

}  // namespace remesher
