// SPDX-License-Identifier: MIT
// A lattice of points around a mesh, with two cells to spare on all sides. Cells are cubes, except
// beside planes that were added. A point is named by one number; an edge by its axis and the point
// at its lower end; a cell by its lowest corner.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "base/triangle_mesh.h"

namespace remesher {

class Lattice {
 public:
  // spacing: the length of a cell, longer where the mesh's coordinates have too few digits. spare:
  // how far the lattice reaches beyond the mesh, at least. Coordinates of points are in single
  // precision if the mesh's are: so a vertex in a plane of the lattice still lies in it when
  // written.
  Lattice(const TriangleMesh& mesh, double spacing, double spare = 0);

  // The same with further planes, per axis ascending. Planes that lie too near to their neighbours
  // for the mesh's coordinates are left out.
  Lattice withPlanes(const std::array<std::vector<double>, 3>& planes) const;

  std::size_t size() const { return counts_[0] * counts_[1] * counts_[2]; }
  std::size_t count(std::size_t axis) const { return counts_[axis]; }
  // From a point to the next one along the axis.
  std::size_t stride(std::size_t axis) const { return strides_[axis]; }
  double spacing() const { return spacing_; }  // of the cubes
  // A share of a cell's width, or more where rounding needs more: a vertex so far within a cell is
  // still within it when written.
  double margin(double share) const { return std::max(share, leastMargin_); }
  double at(std::size_t axis, std::size_t i) const { return coordinates_[axis][i]; }

  std::size_t number(const std::array<std::size_t, 3>& i) const {
    return i[0] * strides_[0] + i[1] * strides_[1] + i[2] * strides_[2];
  }
  std::array<std::size_t, 3> place(std::size_t point) const {
    return {point / strides_[0], point / strides_[1] % counts_[1], point % counts_[2]};
  }
  Vec3 position(const std::array<std::size_t, 3>& i) const {
    return {at(0, i[0]), at(1, i[1]), at(2, i[2])};
  }
  Vec3 position(std::size_t point) const { return position(place(point)); }

  // Calls visit(point, place) for each point, ascending.
  template <class Visit>
  void forEachPoint(Visit visit) const {
    std::size_t point = 0;
    for (std::array<std::size_t, 3> i{}; i[0] < counts_[0]; ++i[0])
      for (i[1] = 0; i[1] < counts_[1]; ++i[1])
        for (i[2] = 0; i[2] < counts_[2]; ++i[2]) visit(point++, i);
  }

  // The same, descending.
  template <class Visit>
  void forEachPointBackwards(Visit visit) const {
    std::size_t point = size();
    std::array<std::size_t, 3> i{};
    for (i[0] = counts_[0]; i[0]-- > 0;)
      for (i[1] = counts_[1]; i[1]-- > 0;)
        for (i[2] = counts_[2]; i[2]-- > 0;) visit(--point, i);
  }

  bool isOnBorder(const std::array<std::size_t, 3>& i) const {
    return i[0] == 0 || i[0] + 1 == counts_[0] || i[1] == 0 || i[1] + 1 == counts_[1] ||
           i[2] == 0 || i[2] + 1 == counts_[2];
  }

  // The extent of the cell along the axis.
  double width(std::size_t axis, const std::array<std::size_t, 3>& cell) const {
    return at(axis, cell[axis] + 1) - at(axis, cell[axis]);
  }

  // The first index along the axis at the coordinate or beyond; count(axis) if there is none.
  std::size_t firstFrom(std::size_t axis, double coordinate) const;

 private:
  double rounded(double coordinate, Eigen::Index axis) const;
  void countPoints();

  double spacing_, quantum_, leastMargin_;
  std::optional<Frame> frame_;  // of coordinates in single precision
  std::array<std::size_t, 3> counts_{}, strides_{};
  std::array<std::vector<double>, 3> coordinates_;
};

}  // namespace remesher
