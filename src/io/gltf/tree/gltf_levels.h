// SPDX-License-Identifier: MIT
// Levels of detail of nodes, by MSFT_lod or by names, `rock_LOD0` beside `rock_LOD1`: which meshes
// stand for which from afar; and how they go.
#pragma once

#include <map>
#include <set>

#include "io/gltf/tree/json.h"

namespace remesher::io {

// By the number of the mesh of a coarser level: those of the finest that it is one of. What is in a
// finest level itself is no other's.
std::map<int, std::set<int>> meshLevels(const Json& tree);
// The same of those that are told by names, all of which the scene shows.
std::map<int, std::set<int>> meshLevelsByName(const Json& tree);

// Takes the levels from nodes and returns the nodes that were those.
std::set<std::size_t> takeLevels(Json& tree);

// Nodes that nothing else names go, with what hangs below them and their meshes; all stay where an
// unknown extension may name one by its number. Returns the accessors that the meshes named.
std::set<int> dropNodes(Json& tree, const std::set<std::size_t>& nodes);

}  // namespace remesher::io
