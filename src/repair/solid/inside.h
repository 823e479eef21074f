// SPDX-License-Identifier: MIT
// Which points of a lattice lie inside: those that most of the six half lines along the axes say to
// be enclosed. Of a closed surface all six agree and are right; beside a hole some are wrong, and
// neighbours that no surface parts from a point have a say as well.
#pragma once

#include <vector>

#include "repair/solid/crossings_of_edges.h"

namespace remesher {

struct InsideField {
  std::vector<float> shares;   // per point: how sure it lies inside, 0 to 1
  std::vector<char> isInside;  // per point
  double unsure = 0;          // of the points beside the surface, the share that half lines dispute
  std::vector<Index> sheets;  // triangles that nothing lies behind
};

// The crossings' triangles face outwards. The border of the lattice is outside, and so is only what
// hangs together with it, or with points of `kept`: other cavities are filled.
InsideField insideField(const Lattice& lattice, std::span<const EdgeCrossing> crossings,
                        std::span<const std::size_t> kept);

// What is outside but hangs together neither with the border, which is, nor with points of `kept`
// that are, becomes inside.
void fillCavities(const Lattice& lattice, std::span<const std::size_t> kept,
                  std::vector<char>& isInside);

}  // namespace remesher
