// SPDX-License-Identifier: MIT
// Places on a surface for a mesh that was not made of it: of its corners the nearest places that
// face the same way.
#pragma once

#include <vector>

#include "geometry/triangle_tree.h"
#include "textures/painting/paint_source.h"

namespace remesher {

class PlaceSearch {
 public:
  // The source must outlive the object.
  explicit PlaceSearch(const PaintSource& source);

  // The nearest place that faces like the normal; the nearest of all if none near by does.
  InputPlace at(const Vec3& point, const Vec3& normal) const;

 private:
  InputPlace on(InputTriangle triangle, const Vec3& point) const;

  const PaintSource& source_;
  TriangleTree tree_;
  double farthest_;  // how far is near by
};

// Per corner of the mesh its place: looked for slightly inside of the corner's triangle, so that at
// a sharp edge each side finds its own.
std::vector<InputPlace> placesOn(const TriangleMesh& mesh, const PaintSource& source);

// Whether each triangle of the mesh lies on a triangle of the source: without normals the mesh then
// looks like a source that is shaded facet by facet. places: of its corners, by placesOn.
bool liesOnFacets(const TriangleMesh& mesh, const PaintSource& source,
                  const std::vector<InputPlace>& places);

}  // namespace remesher
