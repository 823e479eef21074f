// SPDX-License-Identifier: MIT
// Bodies that touch, as one complex of triangles: each common face is there once, and all triangles
// meet in common corners and edges only.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "base/report.h"
#include "base/triangle_mesh.h"
#include "contact/touching.h"

namespace remesher {

// Of which body a triangle is, and in which group of the mesh.
struct BodySide {
  Index body = kNone, group = 0;

  auto operator<=>(const BodySide&) const = default;
};

struct ComplexTriangle {
  std::array<Index, 3> corners;
  BodySide own;    // counterclockwise seen from outside of this body
  BodySide other;  // of a common face: the body that it is turned over for; else without a body
  // Of a face that touches another body: its number, and its area over its length.
  Index face = kNone;
  double width = 0;
};

struct BodyComplex {
  std::vector<Vec3> points;
  std::vector<ComplexTriangle> triangles;
  std::vector<char> isClosed;  // per body
  Touching touching;
  std::size_t left = 0;  // sets of touching faces that were left as they are
  Vec3 leftAt = Vec3::Zero();
};

// pieces: see bodiesOf. Bodies that touch nothing have their triangles as given.
BodyComplex complexOf(const TriangleMesh& mesh, std::span<const Index> pieces,
                      const TouchLimits& limits);

// The triangles of a body, as its own; without other bodies'.
std::vector<std::array<Index, 3>> trianglesOf(const BodyComplex& complex, Index body);

// The sides of a triangle of the complex: its own, and the other of a common face.
using BodySides = std::pair<BodySide, BodySide>;

// The common faces of a mesh made of the complex, whose groups are numbers of such sides.
ConformReport commonFacesIn(const TriangleMesh& mesh, std::span<const BodySides> sides);

struct JunctionLengths {
  double wanted;   // on average
  double longest;  // of any part
};

// Divides the edges at which three triangles or more meet, evenly.
void divideJunctions(BodyComplex& complex, const JunctionLengths& lengths);

// Halves edges within touching faces that are wider than this until none is longer: sizes of
// triangles are known at vertices, and a face may have none but on its border.
void divideWithin(BodyComplex& complex, double longest);

}  // namespace remesher
