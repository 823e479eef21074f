// SPDX-License-Identifier: MIT
// The border between inside and outside of a lattice as a surface that follows the input: closed, a
// 2-manifold, facing outwards, without self-intersections, whatever the input is.
//
//   e --- e     In each cell every loop of segments over the cell's faces is joined to one vertex
//   | \ / |     within the cell, the apex. It goes to where the planes of the triangles at the loop
//   |  a  |     are nearest [Ju, Losasso, Schaefer, Warren, Dual Contouring of Hermite Data,
//   | / \ |     SIGGRAPH 2002]. Where a sharp edge leaves the cell the face gets a vertex, too
//   [after e --- e     Ju, Udeshi, Intersection-Free Contouring on an Octree Grid, PG 2006].
//
// Why nothing passes through itself: seen from a point within a convex cell, a loop on the cell's
// border hides nothing of itself, so the triangles that join them have nothing else in common; and
// cells have only faces in common, where both have the same segments. Cells of several loops are
// looked at one by one, exactly, and are filled if need be.
#pragma once

#include <span>
#include <vector>

#include "repair/solid/crossings_of_edges.h"
#include "repair/solid/inside.h"

namespace remesher {

struct Contour {
  std::vector<Vec3> points;
  std::vector<Index> corners;          // three points for each triangle
  std::vector<Index> pointSources;     // per point: a triangle of the input, or kNone
  std::vector<Index> triangleSources;  // per triangle: the same
};

// The oriented triangles that the crossings number.
struct SolidSource {
  std::span<const Vec3> positions;
  std::span<const Index> corners;
  bool isSingle;  // places in single precision, which is times `scale`
  double scale;
};

// Fills points of the field where it must.
Contour contourOf(const Lattice& lattice, InsideField& field, const SolidSource& source,
                  std::vector<EdgeCrossing> crossings);

}  // namespace remesher
