// SPDX-License-Identifier: MIT
// Surfaces as programs for simulation and printing know them: points, faces of three or four of
// them, and named sets of faces. A set is a material, an OBJ's group, a solid of an STL, or a mesh.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "base/types.h"
#include "io/model/model.h"

namespace remesher::io {

struct NamedFaces {
  struct Face {
    std::array<Index, 4> corners;  // of a triangle the first three
    Index count;                   // corners: 3 or 4
    Index set;                     // index into `names`
  };

  std::vector<Vec3> positions;
  std::vector<Face> faces;
  std::vector<std::string> names;  // of the sets: distinct, none empty
  bool isExact = false;            // some coordinate is no float
};

// The surfaces of all instances, in world space, their faces in the order of the sets, in a set
// triangles first. Corners of a mesh at one position share a point; meshes share none. Sets of the
// same name are one. Throws Error: NO_TRIANGLES.
NamedFaces namedFacesOf(const Model& model);

// The runs of faces of one set with equally many corners.
std::vector<std::span<const NamedFaces::Face>> runsOf(const NamedFaces& surface);

// A model of one part whose groups are the sets; `groups` of the mesh stays empty where there is
// one set without a name. Throws Error: NO_TRIANGLES.
Model modelOf(NamedFaces faces, const std::string& fileName);

}  // namespace remesher::io
