// SPDX-License-Identifier: MIT
// Makes closed bodies of sheets. One side of a body is the sheet, moved or as it is; the other is
// the same sheet moved the other way, or a flat base; walls along the sheet's loops join both.
#pragma once

#include <vector>

#include "base/report.h"
#include "base/triangle_mesh.h"

namespace remesher {

struct BodyRule {
  enum class Kind {
    Thick,  // both sides move along their normals, each by half the thickness
    Base,  // the sheet stays; its base is flat and lies below it, seen along the axis that it faces
  };
  Kind kind = Kind::Thick;
  double thickness = 0;  // a length; of a base, below the lowest point of the sheet
};

struct SheetBodies {
  TriangleMesh mesh;
  std::vector<SizedPlace> madeAt;  // the box of each sheet that became a body: its middle, its size
  std::vector<Vec3> leftAt;        // of each sheet whose outline folds over itself, seen from above
};

// Open components become bodies, closed ones stay as they are; two sides of a body may still
// intersect. Attributes come along: both sides and the walls have those of the sheet, and their own
// normals. Throws Error as buildMesh does.
SheetBodies bodiesOfSheets(const TriangleMesh& mesh, const BodyRule& rule);

// Of parts with one side only, each of whose triangles has three distinct corners: what is moved is
// their double cover, which has two sides.
SheetBodies bodiesOfOneSided(const TriangleMesh& mesh, double thickness);

}  // namespace remesher
