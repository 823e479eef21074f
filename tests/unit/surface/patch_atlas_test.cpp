// SPDX-License-Identifier: MIT
#include "surface/patch_atlas.h"

#include <doctest/doctest.h>

#include "support/patch_shapes.h"

using namespace remesher;
using namespace remesher::patch_shapes;

namespace {

Vec3 position(const Shape& shape, const SurfacePoint& p) {
  const auto [a, b, c] = shape.mesh.vertices(p.face);
  return p.barycentric[0] * shape.positions[a] + p.barycentric[1] * shape.positions[b] +
         p.barycentric[2] * shape.positions[c];
}

}  // namespace

TEST_CASE("patch_atlas: three equal corners give their own point, on every face of every shape") {
  for (const Shape& shape : allShapes()) {
    CAPTURE(shape.name);
    PatchAtlas atlas(shape.mesh, shape.positions, 0.5);
    for (Index f = 0; f < shape.mesh.faceCapacity(); ++f) {
      const SurfacePoint corner{Face(f), Vec3(0.2, 0.5, 0.3)};
      const auto point = atlas.interpolate({corner, corner, corner}, Vec3(0.25, 0.25, 0.5));
      REQUIRE(point);
      CHECK((position(shape, *point) - position(shape, corner)).norm() < 1e-9);
    }
  }
}
