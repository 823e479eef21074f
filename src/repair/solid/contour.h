// SPDX-License-Identifier: MIT
// The border between inside and outside of a lattice as a surface that follows the input: closed, a
// 2-manifold, facing outwards, without self-intersections, whatever the input is.
//
//   e --- e     In each cell every loop of segments over the cell's faces is joined to one vertex
//   | \ / |     within the cell, the apex, as near as possible to the planes of the triangles
//   |  a  |     at the loop [Ju, Losasso, Schaefer, Warren, Dual Contouring of Hermite Data,
//   | / \ |     SIGGRAPH 2002]. Where a sharp edge leaves the cell, the face gets a vertex, too
//   e --- e     [after Ju, Udeshi, Intersection-Free Contouring on an Octree Grid, PG 2006].
//
// Why the surface does not intersect itself: seen from a point within a convex cell, no part of a
// loop on the cell's border hides another, so triangles from the loop to the point meet only in
// common edges and corners; and cells share only faces, on which both have the same segments. Cells
// of several loops are checked one by one, exactly, and are filled if need be.
#pragma once

#include <span>
#include <vector>

#include "base/frame.h"
#include "repair/solid/apex.h"
#include "repair/solid/crossings_of_edges.h"
#include "repair/solid/inside.h"

namespace remesher {

struct Contour {
  std::vector<Vec3> points;
  std::vector<Index> corners;          // three points for each triangle
  std::vector<Index> pointSources;     // per point: a triangle of the input, or kNone
  std::vector<Index> triangleSources;  // per triangle: the same
};

// The oriented triangles; the crossings name them by number.
struct SolidSource {
  std::span<const Vec3> positions;
  std::span<const Index> corners;
  bool isSingle;                  // positions are written in single precision
  Frame frame;                    // of the positions
  Ridges ridges = Ridges::Sharp;  // that get vertices
};

// Makes points of the field inside where loops of a cell cannot be kept apart.
Contour contourOf(const Lattice& lattice, InsideField& field, const SolidSource& source,
                  std::vector<EdgeCrossing> crossings);

}  // namespace remesher
