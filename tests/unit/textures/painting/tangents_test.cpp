// SPDX-License-Identifier: MIT
#include "textures/painting/tangents.h"

#include <doctest/doctest.h>

using namespace remesher;

TEST_CASE("tangents: along u, on the side that the texture is on") {
  const std::vector<Vec3> positions = {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}};
  const std::vector<Vec3> normals(3, Vec3::UnitZ());
  // v grows downwards: with u to the right and v against y the bitangent is +y.
  const std::vector<Vec2> upright = {{0, 1}, {1, 1}, {0, 0}}, mirrored = {{1, 1}, {0, 1}, {1, 0}};
  for (const auto& t : computeTangents({positions, normals, upright})) {
    CHECK((t - Eigen::Vector4d(1, 0, 0, 1)).norm() < 1e-12);
  }
  for (const auto& t : computeTangents({positions, normals, mirrored})) {
    CHECK((t - Eigen::Vector4d(-1, 0, 0, -1)).norm() < 1e-12);
  }
}
