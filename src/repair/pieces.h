// SPDX-License-Identifier: MIT
// The connected pieces of a surface: which are closed, which way they face, and how they lie in
// each other. Decided on the triangles, exactly.
#pragma once

#include <span>
#include <vector>

#include "geometry/box.h"
#include "mesh/mesh_builder.h"

namespace remesher {

struct SurfacePiece {
  // A shell lies inside a solid and faces the way the solid does: nobody sees it, and no cavity is
  // behind it.
  enum class Kind { Open, Solid, Cavity, Shell };
  Kind kind = Kind::Open;
  bool isFlat = true;        // all faces are turned the same way, nearly
  bool isInsideOut = false;  // a closed piece that faces the other way than its kind should
  double volume = 0;         // signed; positive if it faces outwards. Of open pieces: not defined
  double area = 0;
  std::size_t faces = 0;
  Box box;
};

struct Pieces {
  std::vector<Index> ofFace;         // per face of the built mesh its piece
  std::vector<SurfacePiece> pieces;  // in the order of their first faces
};

// isCrossed: per triangle of the built mesh's input whether it intersects others. A piece with such
// triangles lies in no other piece, unless these are few and it bounds a cavity there.
Pieces piecesOf(const BuiltMesh& built, std::span<const char> isCrossed);

}  // namespace remesher
