// SPDX-License-Identifier: MIT
// The rounding of coordinates in files.
#pragma once

#include <span>

#include "base/types.h"

namespace remesher {

// An edge or a height below this is noise, model units: a few roundings in single precision, or the
// step of decimal or binary digits of which all coordinates are whole multiples. It is no more than
// a small share of the model's size, which coarse steps may describe exactly.
double coordinateStep(std::span<const Vec3> positions);

}  // namespace remesher
