// SPDX-License-Identifier: MIT
// The report and the warnings of a repair.
#pragma once

#include <vector>

#include "repair/exact_repair.h"
#include "repair/one_sided.h"
#include "repair/repair.h"
#include "repair/solid/solid.h"

namespace remesher {

// The middle of the first of these triangles, if there is one.
std::vector<Vec3> centreOfFirst(const TriangleMesh& mesh, const std::vector<Index>& triangles);

// Nothing if the warning counts nothing. It is about the first of the places.
void addWarning(RepairedMesh& result, Warning warning, const std::vector<Vec3>& places = {});

void warnOfCrossings(RepairedMesh& result, const std::vector<Index>& crossings);

// Nothing if there are none.
void warnOfOneSided(RepairedMesh& result, const OneSided& found);

// hiddenAt: the bodies that were removed.
void warnOfHidden(RepairedMesh& result, std::vector<SizedPlace> hiddenAt);

// The result of exact steps, reported under this mode.
RepairedMesh asRepaired(ExactRepair exact, const char* mode);

// The result of a lattice made by the rule.
RepairedMesh asRepaired(Solid solid, const TriangleMesh& input, const SolidRule& rule);

}  // namespace remesher
