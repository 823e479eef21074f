// SPDX-License-Identifier: MIT
// From a point of a new triangle to its place on the original: the nearest place along the normal,
// in both directions, that faces the same way; if there is none, the nearest place in space that
// does. Only triangles within a ball around the new triangle and connected there to the places of
// its corners are searched. So on touching sheets, and on the two sides of a thin wall, each side
// finds its own.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "textures/painting/paint_finder.h"
#include "textures/painting/paint_source.h"

namespace remesher {

class SideFinder : public PaintFinder {
 public:
  explicit SideFinder(const PaintSource& source);

  void enter(const NewTriangle& triangle) override;

  // The place for a point on the triangle or slightly beside it; normal: unit.
  InputPlace find(const Vec3& point, const Vec3& normal);

  std::optional<InputPlace> placeFor(const Vec3& point, const Vec3& normal) override {
    return find(point, normal);
  }
  std::optional<MovingPlace> findMoving(const Vec3& point, const Vec3& normal,
                                        const std::array<Vec3, 2>& ways) override;

 private:
  // A searched triangle, prepared for intersection with a line.
  struct Facet {
    InputTriangle triangle;
    Vec3 origin, normal;
    std::array<Vec3, 2> gradients;  // of the first two weights, which are 0 at the origin
  };
  struct Hit {
    InputPlace place;
    double distance = kInfinity;
  };

  Facet facetOf(InputTriangle triangle) const;
  // Moves a facet to the front of last_, from position `before`.
  void remember(std::size_t facet, std::size_t before);
  // Where the line meets the facet, if the facet faces the same way. The distance is infinite if
  // they do not meet, or not nearer than `limit`.
  static Hit meet(const Facet& facet, const Vec3& point, const Vec3& normal, double limit);
  InputPlace nearest(const Vec3& point, const Vec3& normal) const;

  const PaintSource& source_;
  std::vector<InputTriangle> near_;          // the searched triangles
  std::vector<Facet> facets_;                // the same
  HandleData<InputTriangle, Index> stamps_;  // when each was last entered
  Index stamp_ = 0;
  double reach_ = 0;
  // The facets that were met last, latest first: the next query mostly meets one of them.
  std::array<std::size_t, 4> last_{};
};

}  // namespace remesher
