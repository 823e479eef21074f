// SPDX-License-Identifier: MIT
// How fine the lattice of a repair is, and what the repair takes: known from the input before the
// work begins.
#pragma once

#include "base/part_options.h"
#include "base/report.h"
#include "base/triangle_mesh.h"
#include "geometry/extent.h"
#include "repair/solid/solid.h"

namespace remesher {

// The gap of a wrap in percent of the diagonal: the one asked for, or a usual one.
double usualGap(const PartOptions& options);

// Half the target edge length; without one, a usual share of the diagonal.
double wishedSpacing(const Extent& extent, const PartOptions& options);

// The wished spacing, but fine enough to show parts, and as coarse as memory asks for.
SolidRule ruleFor(const TriangleMesh& input, const PartOptions& options, InsideBy by);

// The time and memory of the repair that the options ask for. Approximate.
RepairNeeds needsOf(const TriangleMesh& input, const PartOptions& options);

// Throws OUT_OF_MEMORY for a repair that no memory of `most` bytes can hold; most: all addresses
// there are if not given.
void requireMemory(const TriangleMesh& input, const PartOptions& options);
void requireMemory(const TriangleMesh& input, const PartOptions& options, double most);

}  // namespace remesher
