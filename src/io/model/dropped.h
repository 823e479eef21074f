// SPDX-License-Identifier: MIT
// What a format has no place for, said once.
#pragma once

#include <string>
#include <vector>

#include "base/report.h"
#include "io/model/model.h"

namespace remesher::io {

// ATTRIBUTE_NOT_CARRIED for all attributes of the model but those in `kept`; or no warning.
std::vector<Warning> droppedAttributes(const Model& model, const std::vector<std::string>& kept,
                                       const std::string& format);

}  // namespace remesher::io
