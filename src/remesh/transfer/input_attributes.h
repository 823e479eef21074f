// SPDX-License-Identifier: MIT
// The input's attributes at any place on it, and the places nearest to given points.
#pragma once

#include <string>
#include <vector>

#include "base/input_place.h"
#include "geometry/triangle_tree.h"
#include "mesh/attribute_mix.h"
#include "original/surface/original_surface.h"

namespace remesher {

class InputAttributes {
 public:
  // built: from the input, which must outlive the object; chartless: as in AttributeMix.
  InputAttributes(const TriangleMesh& input, BuiltMesh built, std::vector<std::string> chartless);

  const TriangleMesh& input() const { return input_; }
  const OriginalSurface& surface() const { return surface_; }
  // weights: as in InputPlace.
  Vec3 position(InputTriangle triangle, const Vec3& weights) const;
  Face faceNear(const Vec3& p) const;
  InputPlace placeIn(Face face, const Vec3& p) const;  // the nearest to p

  // Appends the values at a place, one list per attribute of the input and in its order. At a
  // vertex these are its own.
  void append(const InputPlace& place, std::vector<Attribute>& values) const;

 private:
  SurfacePoint pointOf(const InputPlace& place, Face face) const;

  const TriangleMesh& input_;
  const std::vector<std::string> chartless_;
  const OriginalSurface surface_;
  const AttributeMix mix_;
  const ListedTree tree_;
  HandleData<InputTriangle, Face> faces_;  // none for triangles that the builder left out
};

}  // namespace remesher
