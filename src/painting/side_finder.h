// SPDX-License-Identifier: MIT
// From a point of a new triangle to the place of the original that it stands for: along the normal,
// both ways, the nearest that faces the same way; where there is none, the nearest of those that
// do. Looked at is only what hangs together, within a ball about the triangle, with the places that
// its corners remember: of sheets that touch, or a thin wall's two sides, each finds its own.
#pragma once

#include <array>
#include <vector>

#include "painting/paint_source.h"

namespace remesher {

struct NewTriangle {
  Triangle corners;
  std::array<InputPlace, 3> places;  // of the corners on the original
};

class SideFinder {
 public:
  explicit SideFinder(const PaintSource& source);

  // The triangle that is asked about from now on.
  void enter(const NewTriangle& triangle);

  // The place for a point of it, or a little beside it; normal: unit.
  InputPlace find(const Vec3& point, const Vec3& normal);

 private:
  struct Hit {
    InputPlace place;
    double distance;
  };

  bool faces(Index triangle, const Vec3& normal) const;
  // Where the line meets the triangle; the distance is infinite where it does not.
  Hit meet(Index triangle, const Vec3& point, const Vec3& normal) const;
  InputPlace nearest(const Vec3& point, const Vec3& normal) const;

  const PaintSource& source_;
  std::vector<Index> near_;    // the triangles looked at
  std::vector<Index> stamps_;  // by triangle: when it was last entered
  Index stamp_ = 0;
  double reach_ = 0;
  Index last_ = kNone;  // the last answer's triangle: most often the next one's
};

}  // namespace remesher
