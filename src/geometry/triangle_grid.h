// SPDX-License-Identifier: MIT
// Finds what is near a place among changing triangles: a grid of cells in a table of fixed size.
//
// Each triangle is entered on the level whose cells are as large as its box, so it is in at most
// eight cells. Different cells may share a line of the table, so the caller checks each triangle.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/triangle_tree.h"

namespace remesher {

class TriangleGrid {
 public:
  // cell: width of the smallest cells, about a triangle's; expected: the approximate number of
  // triangles.
  TriangleGrid(double cell, std::size_t expected);

  // Add a changed triangle again: its old entry stays, and costs one extra look.
  void add(Index name, const Box& box);

  // Calls visit(name) once for each triangle whose box, as it was when added, may overlap `box`.
  template <class Visit>
  void visit(const Box& box, Visit&& visit) const;

 private:
  using Cell = std::array<std::int64_t, 3>;

  int levelOf(const Box& box) const;
  Cell cellAt(const Vec3& p, int level) const;
  std::size_t lineOf(const Cell& cell, int level) const;
  template <class Visit>
  void forEachLine(const Box& box, int level, Visit visit) const;

  double cell_;
  std::array<bool, 64> isUsed_{};             // per level
  std::vector<std::vector<Index>> lines_;     // their number is a power of two
  mutable std::vector<std::uint32_t> asked_;  // per name: the last query that met it
  mutable std::uint32_t question_ = 0;
};

template <class Visit>
void TriangleGrid::forEachLine(const Box& box, int level, Visit visit) const {
  const Cell low = cellAt(box.low, level), high = cellAt(box.high, level);
  for (Cell c = low; c[0] <= high[0]; ++c[0])
    for (c[1] = low[1]; c[1] <= high[1]; ++c[1])
      for (c[2] = low[2]; c[2] <= high[2]; ++c[2]) visit(lineOf(c, level));
}

template <class Visit>
void TriangleGrid::visit(const Box& box, Visit&& visit) const {
  ++question_;
  const auto ask = [&](const std::vector<Index>& line) {
    for (const Index name : line)
      if (asked_[name] != question_) {
        asked_[name] = question_;
        visit(name);
      }
  };
  for (int level = 0; level < int(isUsed_.size()); ++level) {
    if (!isUsed_[std::size_t(level)]) continue;
    const Cell low = cellAt(box.low, level), high = cellAt(box.high, level);
    double cells = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) cells *= double(high[axis] - low[axis] + 1);
    if (cells > double(lines_.size())) {
      for (const std::vector<Index>& line : lines_) ask(line);
      return;
    }
    forEachLine(box, level, [&](std::size_t line) { ask(lines_[line]); });
  }
}

}  // namespace remesher
