// SPDX-License-Identifier: MIT
// From a point of a new triangle to the place of the original that it stands for: along the normal,
// both ways, the nearest that faces the same way; where there is none, the nearest of those that
// do. Looked at is only what hangs together, within a ball about the triangle, with the places that
// its corners remember: of sheets that touch, or a thin wall's two sides, each finds its own.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "textures/painting/paint_source.h"

namespace remesher {

struct NewTriangle {
  Triangle corners;
  std::array<InputPlace, 3> places;  // of the corners on the original
};

// A place, and how its weights change where the point that it is the place of moves two ways.
struct MovingPlace {
  InputPlace place;
  Vec3 perX, perY;
};

class SideFinder {
 public:
  explicit SideFinder(const PaintSource& source);

  // The triangle that is asked about from now on.
  void enter(const NewTriangle& triangle);

  // The place for a point of it, or a little beside it; normal: unit.
  InputPlace find(const Vec3& point, const Vec3& normal);

  // The same, if it is along the normal, for a point that may move two ways: as long as no weight
  // falls below zero, the place is on the same triangle.
  std::optional<MovingPlace> findMoving(const Vec3& point, const Vec3& normal,
                                        const std::array<Vec3, 2>& ways);

 private:
  // A triangle looked at, with what a line is met by.
  struct Facet {
    Index triangle;
    Vec3 origin, normal;
    std::array<Vec3, 2> gradients;  // of the first two weights, which are 0 at the origin
  };
  struct Hit {
    InputPlace place;
    double distance = std::numeric_limits<double>::infinity();
  };

  Facet facetOf(Index triangle) const;
  // Puts a facet before all others that were met, of which so many come behind it.
  void remember(std::size_t facet, std::size_t before);
  // Where the line meets the facet, if that faces the same way; the distance is infinite if the
  // line does not, or no nearer than `limit`.
  static Hit meet(const Facet& facet, const Vec3& point, const Vec3& normal, double limit);
  InputPlace nearest(const Vec3& point, const Vec3& normal) const;

  const PaintSource& source_;
  std::vector<Index> near_;    // the triangles looked at
  std::vector<Facet> facets_;  // the same
  std::vector<Index> stamps_;  // by triangle: when it was last entered
  Index stamp_ = 0;
  double reach_ = 0;
  // The facets that were met last, the latest first: most often one of them is the next one's.
  std::array<std::size_t, 4> last_{};
};

}  // namespace remesher
