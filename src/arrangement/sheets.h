// SPDX-License-Identifier: MIT
// Where triangles meet each other: the points and segments to cut each one along. Triangles of one
// plane that meet make a sheet, which is cut as a whole: so their overlaps are cut alike.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "arrangement/facets.h"
#include "arrangement/sheet_triangulation.h"

namespace remesher {

struct Sheet {
  std::vector<Index> triangles;  // ascending
  std::vector<Index> points;
  std::vector<Segment> segments;
};

struct FoundSheets {
  std::vector<Sheet> all;  // in the order of their lowest triangles
  std::size_t work = 0;    // pairs and points
};

// All sheets of triangles that meet another triangle beyond common corners and edges. Nothing if
// that would take more than so many steps.
std::optional<FoundSheets> findSheets(PointPool& points, const ArrangedTriangles& triangles,
                                      std::size_t mostWork);

}  // namespace remesher
