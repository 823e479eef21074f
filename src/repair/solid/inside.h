// SPDX-License-Identifier: MIT
// Which points of a lattice lie inside: those that most of their six half lines along the axes find
// enclosed. For a closed surface all six agree and are right. Beside a hole some are wrong, so
// neighbours that no surface separates from a point count as well.
#pragma once

#include <vector>

#include "repair/solid/crossings_of_edges.h"

namespace remesher {

struct InsideField {
  std::vector<float> shares;   // per point: how sure it lies inside, 0 to 1
  std::vector<char> isInside;  // per point
  double unsure = 0;           // share of the points beside the surface where half lines disagree
  std::vector<Index> sheets;   // per crossing with the outside on both sides: its triangle
};

// The crossings' triangles face outwards. Outside are the border of the lattice and the points
// connected with it or with points of `kept`; other cavities are filled.
InsideField insideField(const Lattice& lattice, std::span<const EdgeCrossing> crossings,
                        std::span<const std::size_t> kept);

// Outside points become inside if they are connected neither with the lattice's border, which is
// outside, nor with an outside point of `kept`.
void fillCavities(const Lattice& lattice, std::span<const std::size_t> kept,
                  std::vector<char>& isInside);

}  // namespace remesher
