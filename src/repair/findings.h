// SPDX-License-Identifier: MIT
// What a repair says about what it did: its report and its warnings.
#pragma once

#include <vector>

#include "repair/exact_repair.h"
#include "repair/repair.h"
#include "repair/solid/solid.h"

namespace remesher {

// The middle of the first of these triangles, if there is one.
std::vector<Vec3> centreOfFirst(const TriangleMesh& mesh, const std::vector<Index>& triangles);

// Nothing if the warning counts nothing. It is about the first of the places.
void addWarning(RepairedMesh& result, Warning warning, const std::vector<Vec3>& places = {});

void warnOfCrossings(RepairedMesh& result, const std::vector<Index>& crossings);

// hiddenAt: the bodies that were removed.
void warnOfHidden(RepairedMesh& result, std::vector<SizedPlace> hiddenAt);

// What exact steps did, in this mode.
RepairedMesh asRepaired(ExactRepair exact, const char* mode);

// What a lattice did that was made by the rule.
RepairedMesh asRepaired(Solid solid, const TriangleMesh& input, const SolidRule& rule);

}  // namespace remesher
