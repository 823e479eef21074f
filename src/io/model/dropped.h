// SPDX-License-Identifier: MIT
// Warns once of each kind of thing that a format cannot hold.
#pragma once

#include <string>
#include <vector>

#include "base/report.h"
#include "io/model/model.h"

namespace remesher::io {

// Stands for materials among the semantics.
inline constexpr const char* kMaterial = "materials";

// ATTRIBUTE_NOT_CARRIED for all attributes of the model except those in `kept`, for those that it
// has lost, and for its material if it has one group; no warning if there are none.
std::vector<Warning> droppedAttributes(const Model& model, const std::vector<std::string>& kept,
                                       const std::string& format);

// PARTS_MERGED, for a format whose file is one solid, if the model has several parts or groups.
std::vector<Warning> mergedParts(const Model& model);

// MATERIALS_BY_NAME, for a format that refers to materials by name.
std::vector<Warning> namedMaterials(const Model& model);

}  // namespace remesher::io
