// SPDX-License-Identifier: MIT
// From a point of any mesh to a place on an original near it: the nearest place along the normal,
// in both directions, that faces the same way; if there is none, the nearest place in space that
// does; neither is farther away than the cage.
#pragma once

#include "geometry/triangle_tree.h"
#include "textures/painting/paint_finder.h"
#include "textures/painting/paint_source.h"
#include "textures/painting/place_search.h"

namespace remesher {

class CageFinder : public PaintFinder {
 public:
  // cage: a length. source must outlive the object.
  CageFinder(const PaintSource& source, double cage);

  void enter(const NewTriangle& triangle) override;
  std::optional<InputPlace> placeFor(const Vec3& point, const Vec3& normal) override;
  std::optional<MovingPlace> findMoving(const Vec3& point, const Vec3& normal,
                                        const std::array<Vec3, 2>& ways) override;

 private:
  std::optional<InputPlace> alongNormal(const Vec3& point, const Vec3& normal) const;

  const PaintSource& source_;
  TriangleTree tree_;
  PlaceSearch search_;
  double cage_;
};

}  // namespace remesher
