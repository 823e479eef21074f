// SPDX-License-Identifier: MIT
// The bodies of a remeshed complex, each by itself, and as the parts of the file that they belong
// to.
#pragma once

#include <array>
#include <vector>

#include "contact/common_faces.h"
#include "io/model/model.h"

namespace remesher {

// A triangle of a body, by the vertices of the complex.
struct OwnTriangle {
  std::array<Index, 3> corners;
  Index group;  // of the part
};

// A body in the space of its part, with the attributes of the part's surface there but for texture
// coordinates, whose seams no triangle follows.
TriangleMesh bodyIn(const io::Part& part, const std::vector<OwnTriangle>& triangles,
                    const std::vector<Vec3>& positions);

// Whether the part has attributes that its bodies will not have.
bool losesAttributes(const TriangleMesh& mesh);

// The part with the bodies as its mesh.
io::Part withBodies(const io::Part& part, const std::vector<TriangleMesh>& bodies);

}  // namespace remesher
