// SPDX-License-Identifier: MIT
// Units of length, as 3MF calls them; JavaScript has the same in base/lengths.js.
#pragma once

#include <string>
#include <string_view>

#include "io/model/model.h"

namespace remesher::io {

// The unit that a model has: its file's, or metres in glTF; empty if neither says it.
std::string unitOf(const Model& model);

// Metres; 0 if it is no unit of 3MF.
double metresIn(std::string_view unit);

}  // namespace remesher::io
