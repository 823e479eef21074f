// SPDX-License-Identifier: MIT
// Warns once of the attributes that a format cannot hold.
#pragma once

#include <string>
#include <vector>

#include "base/report.h"
#include "io/model/model.h"

namespace remesher::io {

// ATTRIBUTE_NOT_CARRIED for all attributes of the model except those in `kept`; no warning if none.
std::vector<Warning> droppedAttributes(const Model& model, const std::vector<std::string>& kept,
                                       const std::string& format);

}  // namespace remesher::io
