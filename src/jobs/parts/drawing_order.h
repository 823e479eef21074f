// SPDX-License-Identifier: MIT
// The order in which triangles are drawn: of what is seen through, later ones lie over earlier
// ones.
#pragma once

#include <vector>

#include "io/model/model.h"

namespace remesher {

// Brings the faces of parts that are seen through into the order of the originals' triangles that
// they lie on. made: of these originals, one by one.
void keepDrawingOrder(std::vector<io::Part>& made, const std::vector<io::Part>& originals);

}  // namespace remesher
