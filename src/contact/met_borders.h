// SPDX-License-Identifier: MIT
// Brings the borders of faces in one plane together: points nearer than a tolerance become one,
// and where a border meets another both get a point.
#pragma once

#include "contact/flat_faces.h"
#include "geometry/divided_edges.h"

namespace remesher {

// Points of the soup become one, or are added; edges are not divided yet.
DividedEdges meetBorders(BodySoup& soup, const FlatFaces& flat, double tolerance);

}  // namespace remesher
