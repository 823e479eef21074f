// SPDX-License-Identifier: MIT
// The flat faces of bodies that lie on other bodies, and sets of such faces in one plane.
#pragma once

#include <utility>
#include <vector>

#include "contact/body_soup.h"

namespace remesher {

// Triangles of one body and one group that hang together in one plane.
struct FlatFace {
  Vec3 origin = Vec3::Zero(), normal = Vec3::Zero();
  std::vector<Index> triangles;
  std::vector<Index> border;  // corners whose edges to the next ones lead out of the face
};

struct FlatFaces {
  std::vector<FlatFace> faces;
  std::vector<Index> ofTriangle;             // kNone for triangles that touch nothing
  std::vector<std::vector<Index>> clusters;  // faces that touch each other, directly or not
};

// touching: pairs of triangles. tolerance: how far corners may be away from the plane.
FlatFaces flatFacesOf(const BodySoup& soup, const std::vector<std::pair<Index, Index>>& touching,
                      double tolerance);

}  // namespace remesher
