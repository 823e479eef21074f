// SPDX-License-Identifier: MIT
// The triangles of several bodies, with the body of each: a body is a connected piece of surface.
// Where bodies touch, their triangles may share points.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/triangle_mesh.h"

namespace remesher {

struct BodyTriangle {
  std::array<Index, 3> corners;  // points, counterclockwise seen from outside of the body
  Index body;
  Index group;  // of the mesh
};

struct BodySoup {
  std::vector<Vec3> points;
  std::vector<BodyTriangle> triangles;
  // Per corner of a triangle the corner across the edge to the next one, kNone where it is open.
  std::vector<Index> mates;
  std::vector<char> isClosed;  // per body

  const Vec3& at(Index triangle, std::size_t k) const {
    return points[triangles[triangle].corners[k]];
  }
};

// Bodies in the order of their first triangles, each with points of its own. pieces: per triangle
// the number of the mesh that it comes from; bodies never extend over several. Triangles with two
// corners at one place are left out.
BodySoup bodiesOf(const TriangleMesh& mesh, std::span<const Index> pieces);

}  // namespace remesher
