// SPDX-License-Identifier: MIT
// Levels of detail of nodes, by MSFT_lod or by names such as `rock_LOD0` beside `rock_LOD1`: tells
// which meshes are coarser levels of which, and removes levels.
#pragma once

#include <map>
#include <set>

#include "io/gltf/tree/json.h"

namespace remesher::io {

inline constexpr const char* kLevelsExtension = "MSFT_lod";

// Per mesh of a coarser MSFT_lod level the meshes of the finest level. A mesh that is in a finest
// level itself is left out.
std::map<int, std::set<int>> meshLevels(const Json& tree);
// The same for levels by names, all of which the scene shows.
std::map<int, std::set<int>> meshLevelsByName(const Json& tree);

// Removes the levels from the nodes that have them; returns the nodes of the levels.
std::set<std::size_t> takeLevels(Json& tree);

// Drops the nodes that nothing else names, with their descendants and meshes. If an unknown
// extension may name a node by number, all stay. Returns the accessors of the dropped meshes.
std::set<int> dropNodes(Json& tree, const std::set<std::size_t>& nodes);

// Nodes of these meshes stay and show nothing. The meshes are dropped, unless an unknown extension
// may name a mesh by number. Returns the accessors of the dropped meshes.
std::set<int> dropMeshes(Json& tree, const std::set<std::size_t>& meshes);

}  // namespace remesher::io
