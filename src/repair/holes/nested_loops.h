// SPDX-License-Identifier: MIT
// Loops in one plane, one inside the other, between which material lies: the outer and the inner
// wall of a tube or a cup that was cut off there. They get one lid with holes.
#pragma once

#include <cstddef>
#include <vector>

#include "repair/holes/plug.h"

namespace remesher {

// The numbers of the loops of each lid, the outer one first: in the order of the outer ones.
std::vector<std::vector<std::size_t>> lidsOf(const BuiltMesh& built,
                                             const std::vector<Loop>& loops);

// One loop of all that a lid has.
Loop joined(const std::vector<Loop>& loops, const std::vector<std::size_t>& lid);

}  // namespace remesher
