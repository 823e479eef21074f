// SPDX-License-Identifier: MIT
// Finds what is near a place among changing triangles: a grid of cells in a table of fixed size.
//
// Each triangle is entered on the level whose cells are as large as its box, so it is in at most
// eight cells. Different cells may share a line of the table, which is a list.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/box.h"

namespace remesher {

class TriangleGrid {
 public:
  // cell: width of the smallest cells, about a triangle's; expected: the approximate number of
  // triangles.
  TriangleGrid(double cell, std::size_t expected);

  // Enters a triangle, in place of the one of that name, if there is one: whose cells then hold it,
  // too, which costs extra looks.
  void add(Index name, const Box& box);

  // Calls visit(name) once for each triangle whose box overlaps `box`.
  template <class Visit>
  void visit(const Box& box, Visit&& visit) const;

 private:
  using Cell = std::array<std::int64_t, 3>;

  struct Entry {
    Box box;
    mutable std::uint32_t asked = 0;  // the last query that met it
  };
  struct Link {
    Index name, next;
  };

  int levelOf(const Box& box) const;
  Cell cellAt(const Vec3& p, int level) const;
  std::size_t lineOf(const Cell& cell, int level) const;
  template <class Visit>
  void forEachLine(const Box& box, int level, Visit visit) const;
  bool holds(std::size_t line, Index name) const;

  double cell_;
  std::array<bool, 64> isUsed_{};  // per level
  std::vector<Index> lines_;       // the first link of each; their number is a power of two
  std::vector<Link> links_;
  std::vector<Entry> entries_;  // per name
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
  const auto ask = [&](Index name) {
    const Entry& entry = entries_[name];
    if (entry.asked == question_) return;
    entry.asked = question_;
    if (entry.box.overlaps(box)) visit(name);
  };
  for (int level = 0; level < int(isUsed_.size()); ++level) {
    if (!isUsed_[std::size_t(level)]) continue;
    const Cell low = cellAt(box.low, level), high = cellAt(box.high, level);
    double cells = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) cells *= double(high[axis] - low[axis] + 1);
    if (cells > double(lines_.size())) {
      for (Index name = 0; name < entries_.size(); ++name) ask(name);
      return;
    }
    forEachLine(box, level, [&](std::size_t line) {
      for (Index i = lines_[line]; i != kNone; i = links_[i].next) ask(links_[i].name);
    });
  }
}

}  // namespace remesher
