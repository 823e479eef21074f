// SPDX-License-Identifier: MIT
// How a painter comes from a point of a new triangle to a place on the original.
#pragma once

#include <array>
#include <optional>

#include "base/input_place.h"
#include "geometry/triangle.h"

namespace remesher {

struct NewTriangle {
  Triangle corners;
  std::array<InputPlace, 3> places;  // of the corners on the original
};

// A place, and the change of its weights per step of its point in two directions.
struct MovingPlace {
  InputPlace place;
  Vec3 perX, perY;
};

class PaintFinder {
 public:
  PaintFinder() = default;
  PaintFinder(const PaintFinder&) = delete;
  PaintFinder& operator=(const PaintFinder&) = delete;
  virtual ~PaintFinder() = default;

  // The triangle for all following queries.
  virtual void enter(const NewTriangle& triangle) = 0;

  // The place for a point on the triangle or slightly beside it, if there is one; normal: unit.
  virtual std::optional<InputPlace> placeFor(const Vec3& point, const Vec3& normal) = 0;

  // The same for a point that may move in two directions, if the place is along the normal. As long
  // as no weight falls below zero the place stays on the same triangle.
  virtual std::optional<MovingPlace> findMoving(const Vec3& point, const Vec3& normal,
                                                const std::array<Vec3, 2>& ways) = 0;
};

// A place found along a line through a point that faces like the line's direction, as a moving one.
// normal: of the place's triangle; gradients: of its first two weights.
inline MovingPlace movingPlace(const InputPlace& place, const Vec3& direction, const Vec3& normal,
                               const std::array<Vec3, 2>& gradients,
                               const std::array<Vec3, 2>& ways) {
  const double agreement = normal.dot(direction);
  const auto changeBy = [&](const Vec3& way) -> Vec3 {
    const Vec3 along = way - way.dot(normal) / agreement * direction;
    const double a = along.dot(gradients[0]), b = along.dot(gradients[1]);
    return {a, b, -a - b};
  };
  return {place, changeBy(ways[0]), changeBy(ways[1])};
}

}  // namespace remesher
