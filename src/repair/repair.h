// SPDX-License-Identifier: MIT
// A surface mended before anything else is done with it.
#pragma once

#include <optional>
#include <vector>

#include "base/options.h"
#include "base/report.h"
#include "base/triangle_mesh.h"

namespace remesher {

struct PlacedWarning {
  Warning warning;
  std::optional<Vec3> at;  // where the first of it lies
};

struct RepairedMesh {
  TriangleMesh mesh;
  RepairReport report;
  std::vector<PlacedWarning> warnings;
};

// As the options' repair, holesUpTo, gap, cavities and sheets say. Throws Error as requireValid
// does, NO_TRIANGLES if nothing can be kept.
RepairedMesh repairSurface(const TriangleMesh& input, const RemeshOptions& options);

// What is broken, open loops in any order. Throws Error as buildMesh does.
FaultReport faultsOf(const TriangleMesh& input);

}  // namespace remesher
