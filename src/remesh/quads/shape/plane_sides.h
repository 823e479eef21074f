// SPDX-License-Identifier: MIT
// Quads of a half whose mirror images would meet them off the planes: an inner side with both ends
// on a plane is its own image, and a quad with two sides in a plane shares both with its image.
//
//     ===o=======o===        ===o=======o===
//        |       |              | o---o |
//        |       |      ->      | |   | |    then the side between both quads is turned, so that
//        |       |              | o---o |    it ends at the smaller quad
//     ===o=======o===        ===o=======o===
#pragma once

#include "base/part_options.h"
#include "remesh/quads/mesh/quad_mesh.h"

namespace remesher {

// Puts smaller quads into such quads, so that all images meet on planes only. ground: any mesh on
// the same original. Returns the number of smaller quads. Sides on curves stay.
std::size_t partFromImages(QuadMesh& mesh, const Mirrors& mirrors, const WorkingMesh& ground);

}  // namespace remesher
