// SPDX-License-Identifier: MIT
// Which triangles to turn over so that neighbours agree on the outer side. The flood crosses only
// edges with two triangles; in every flooded region the majority keeps its orientation.
#pragma once

#include <span>
#include <vector>

#include "mesh/edge_groups.h"

namespace remesher {

struct Orientation {
  std::vector<char> turn;     // per triangle; empty if none has to be turned
  std::size_t turned = 0;     // triangles
  std::size_t conflicts = 0;  // edges that no choice satisfies: a Möbius strip has some
  Index conflict = kNone;     // a halfedge of the first of them
};

Orientation orient(std::span<const Index> corners, const EdgeGroups& edges);

}  // namespace remesher
