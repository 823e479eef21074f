// SPDX-License-Identifier: MIT
#include "remesh/steps/adapt.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "support/working_meshes.h"

using namespace remesher;

namespace {

// A box of 10 × 1 × 0.5, of twelve triangles.
TriangleMesh plank() {
  TriangleMesh mesh = shapes::cube(1);
  for (Vec3& p : mesh.positions) p = p.cwiseProduct(Vec3(10, 1, 0.5));
  return mesh;
}

}  // namespace

TEST_CASE(
    "adapt: out of a few giant triangles come no needles, and about as many as are asked for") {
  const OriginalSurface surface = shapes::surfaceOf(plank());
  for (const Quality quality : {Quality::Draft, Quality::Best})
    for (const std::size_t vertices : {500, 1500, 4000}) {
      CAPTURE(vertices);
      SizeField sizes(surface, {.vertices = double(vertices), .adaptivity = 0});
      Projector projector(surface, Projection::Patches, 2 * sizes.mean());
      WorkingMesh mesh(surface);
      Run run{mesh, projector, sizes, {{}, effortOf(quality, Level::Finest, vertices)}};
      adaptToSizes(run, vertices, {});
      CHECK(shapes::worstAngle(mesh) > radians(5));
      CHECK(mesh.mesh().vertexCount() > 0.9 * double(vertices));
      CHECK(mesh.mesh().vertexCount() < 1.3 * double(vertices));
      CHECK(shapes::checkWorkingMesh(mesh) == "");
    }
}
