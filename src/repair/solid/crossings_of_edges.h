// SPDX-License-Identifier: MIT
// Where a surface crosses the edges of a lattice. Decided exactly for each line of the lattice; a
// line through the common edge of two triangles is given to one of them. So a line crosses a closed
// surface as often inwards as outwards.
#pragma once

#include <span>
#include <vector>

#include "repair/solid/lattice.h"

namespace remesher {

struct EdgeCrossing {
  std::size_t edge;  // 3 × the point at its lower end + the axis
  double at;         // the coordinate along the axis
  Index triangle;
  int up;  // 1 if the triangle faces along the axis, -1 against it
};

inline Vec3 placeOf(const Lattice& lattice, const EdgeCrossing& c) {
  Vec3 at = lattice.position(c.edge / 3);
  at[Eigen::Index(c.edge % 3)] = c.at;
  return at;
}

// Ascending by axis, line and coordinate. corners: the three positions of each triangle, by number.
std::vector<EdgeCrossing> crossingsOfEdges(const Lattice& lattice, std::span<const Vec3> positions,
                                           std::span<const Index> corners);

// The crossings of one line.
struct CrossedLine {
  std::size_t axis, first;  // the point where it begins
  std::span<const EdgeCrossing> crossings;
};

template <class Visit>
void forEachCrossedLine(const Lattice& lattice, std::span<const EdgeCrossing> crossings,
                        Visit visit) {
  const auto lineOf = [&](const EdgeCrossing& c) {
    const std::size_t axis = c.edge % 3, point = c.edge / 3;
    return point - lattice.place(point)[axis] * lattice.stride(axis);
  };
  for (std::size_t begin = 0, end = 0; begin < crossings.size(); begin = end) {
    const std::size_t axis = crossings[begin].edge % 3, first = lineOf(crossings[begin]);
    while (end < crossings.size() && crossings[end].edge % 3 == axis &&
           lineOf(crossings[end]) == first)
      ++end;
    visit(CrossedLine{axis, first, crossings.subspan(begin, end - begin)});
  }
}

}  // namespace remesher
