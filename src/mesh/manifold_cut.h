// SPDX-License-Identifier: MIT
// Cuts a bag of oriented triangles into a manifold. At an edge of more than two triangles the
// straightest pairs of agreeing orientation stay together and the rest is cut apart; then every fan
// of triangles around a vertex gets a vertex of its own.
#pragma once

#include <span>
#include <vector>

#include "mesh/edge_groups.h"
#include "mesh/fan_cut.h"

namespace remesher {

// corners: vertices of `positions`, three distinct ones per triangle. New vertices keep the order
// of the given ones; further copies follow after all of them.
ManifoldCut cutToManifold(std::span<const Vec3> positions, std::span<const Index> corners,
                          const EdgeGroups& edges);

}  // namespace remesher
