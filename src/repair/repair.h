// SPDX-License-Identifier: MIT
// Repairs a surface before any other step.
#pragma once

#include <optional>
#include <vector>

#include "base/part_options.h"
#include "base/report.h"
#include "base/triangle_mesh.h"
#include "repair/one_sided.h"

namespace remesher {

struct PlacedWarning {
  Warning warning;
  std::optional<Vec3> at;  // the first place that it is about
  double across = 0;       // how wide that is, a length; 0: not said
};

struct RepairedMesh {
  TriangleMesh mesh;
  RepairReport report;
  bool isRemade = false;  // by a lattice: the triangles are not the input's
  std::vector<PlacedWarning> warnings;
};

// Follows the options repair, holesUpTo, keepRims, gap, cavities, sheets, thickness and base.
// Throws the Errors of requireValid, NO_TRIANGLES if nothing can be kept, and OUT_OF_MEMORY, before
// the work, if no memory can hold it.
RepairedMesh repairSurface(const TriangleMesh& input, const PartOptions& options);

// The mesh as closed bodies that intersect nowhere, facing outwards, by the exact steps of repair
// alone; nothing stays open and no lattice is made. None where that is not possible.
std::optional<RepairedMesh> exactBodies(const TriangleMesh& input);

// A corner of each piece of the mesh that stays open when its cracks and holes are closed.
std::vector<Vec3> openPieces(const TriangleMesh& input);

// Parts with one side only that repair leaves as they are, in canonical order of the mesh: it cuts
// and closes what is one-sided by a flaw.
OneSided leftOneSided(const TriangleMesh& input);

// Finds the faults; open loops are in no particular order. Throws the Errors of buildMesh, and
// OUT_OF_MEMORY as above.
FaultReport faultsOf(const TriangleMesh& input);

}  // namespace remesher
