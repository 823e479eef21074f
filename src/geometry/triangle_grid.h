// SPDX-License-Identifier: MIT
// Finds what is near a place among changing triangles: a grid of cells in a table of fixed size.
//
// Each triangle is entered on the level whose cells are as large as its box, so it is in at most
// eight cells. Different cells may share a line of the table, which is a list.
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

  // Enters a triangle, in place of the one of that name, if there is one.
  void add(Index name, const Box& box);

  // Calls visit(name) once for each triangle whose box overlaps `box`.
  template <class Visit>
  void visit(const Box& box, Visit&& visit) const;

 private:
  using Cell = std::array<std::int64_t, 3>;

  struct Cells {
    int level = -1;  // none
    Cell low{}, high{};
    bool operator==(const Cells&) const = default;
  };
  struct Entry {
    Box box;                          // empty if there is none
    mutable std::uint32_t asked = 0;  // the last query that met it
  };
  struct Link {
    Index name, next;
  };

  int levelOf(const Box& box) const;
  Cell cellAt(const Vec3& p, int level) const;
  Cells cellsOf(const Box& box, int level) const {
    return {level, cellAt(box.low, level), cellAt(box.high, level)};
  }
  std::size_t lineOf(const Cell& cell, int level) const;
  template <class Visit>
  void forEachLine(const Cells& cells, Visit visit) const;
  void enter(Index name, std::size_t line);
  void remove(Index name, std::size_t line);

  double cell_;
  std::array<bool, 64> isUsed_{};  // per level
  std::vector<Index> lines_;       // the first link of each; their number is a power of two
  std::vector<Link> links_;
  Index free_ = kNone;          // the first link that is not in use
  std::vector<Entry> entries_;  // per name
  mutable std::uint32_t question_ = 0;
};

template <class Visit>
void TriangleGrid::forEachLine(const Cells& cells, Visit visit) const {
  const auto& [level, low, high] = cells;
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
    const Cells cells = cellsOf(box, level);
    double count = 1;
    for (std::size_t axis = 0; axis < 3; ++axis)
      count *= double(cells.high[axis] - cells.low[axis] + 1);
    if (count > double(lines_.size())) {
      for (Index name = 0; name < entries_.size(); ++name) ask(name);
      return;
    }
    forEachLine(cells, [&](std::size_t line) {
      for (Index i = lines_[line]; i != kNone; i = links_[i].next) ask(links_[i].name);
    });
  }
}

}  // namespace remesher
