// SPDX-License-Identifier: MIT
#include "remesh/quads/field/guide_directions.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "remesh/quads/field/cross_field.h"
#include "support/working_meshes.h"

using namespace remesher;

TEST_CASE("guide directions: crosses turn along a guide, most on it and not a length away") {
  TriangleMesh sheet;
  shapes::addSheet(sheet, 20, 20, [](int x, int y) { return Vec3(0.1 * x, 0.1 * y, 0); });
  const OriginalSurface surface = shapes::surfaceOf(sheet);
  const WorkingMesh mesh(surface);
  const FaceFrames frames(mesh);
  const double angle = radians(30);
  Guide guide;
  for (int i = 0; i <= 10; ++i)
    guide.points.push_back(Vec3(1, 1, 0) +
                           0.05 * (i - 5) * Vec3(std::cos(angle), std::sin(angle), 0));
  const std::vector<Guide> guides = {guide};
  const FaceData<Complex> asked = guideCrosses(mesh, frames, guides, 0.3);
  const CrossField field = makeCrossField(mesh, frames, 0.3, {guides});
  for (Index i = 0; i < asked.size(); ++i) {
    const auto [a, b, c] = mesh.corners(Face(i));
    const Vec3 middle = (a + b + c) / 3;
    const double away = (middle - Vec3(1, 1, 0)).norm();
    if (away > 0.65) CHECK(asked[Face(i)] == 0.0);
    if (away > 0.1) continue;
    CHECK(std::abs(asked[Face(i)]) > 0.4);
    const Vec2 along = frames.inFrame(Face(i), Vec3(std::cos(angle), std::sin(angle), 0));
    const double off =
        std::remainder(std::atan2(along.y(), along.x()) - field.angle[Face(i)], kQuarterTurn);
    CHECK(std::abs(off) < radians(10));
  }
}
