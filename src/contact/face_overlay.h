// SPDX-License-Identifier: MIT
// Faces of one plane laid over each other: triangles, each with the faces that it lies in.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "contact/flat_faces.h"
#include "geometry/divided_edges.h"

namespace remesher {

struct OverlaidTriangle {
  std::array<Index, 3> corners;  // points of the soup, counterclockwise seen from outside of `face`
  Index face;
  Index other = kNone;  // the face on which `face` lies here, of another body
};

// Faces whose borders have met: see meetBorders.
struct MetFaces {
  const BodySoup& soup;
  const FlatFaces& flat;
  const DividedEdges& divided;
};

// cluster: the faces, by their numbers. None where borders cross, or a face leaves the plane.
std::optional<std::vector<OverlaidTriangle>> overlaid(const MetFaces& met,
                                                      const std::vector<Index>& cluster,
                                                      double tolerance);

}  // namespace remesher
