// SPDX-License-Identifier: MIT
#include "textures/painting/occlusion.h"

#include <doctest/doctest.h>

using namespace remesher;

namespace {

// A large floor at z = 0 and, if it is not 0, a wall of this height at x = 0.
struct Corner {
  std::vector<Vec3> positions;
  std::vector<Index> indices;

  explicit Corner(double height) {
    positions = {{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}};
    indices = {0, 1, 2, 0, 2, 3};
    if (height == 0) return;
    for (const Vec3& p : {Vec3(0, -9, 0), Vec3(0, 9, 0), Vec3(0, 9, height), Vec3(0, -9, height)})
      positions.push_back(p);
    for (const Index v : {4, 5, 6, 4, 6, 7}) indices.push_back(v);
  }

  // The mean openness of the floor there, over all rays.
  double at(double x) const {
    const OcclusionMap map(positions, indices);
    double sum = 0;
    for (Index i = 0; i < 16; ++i) sum += map.openness(Vec3(x, 0, 0), Vec3::UnitZ(), i % 4, i / 4);
    return sum / 16;
  }
};

}  // namespace

TEST_CASE("occlusion: all light reaches a plane") { CHECK(Corner(0).at(1) == 1); }

TEST_CASE("occlusion: half of the light reaches the foot of a wall") {
  CHECK(Corner(9).at(0.01) == doctest::Approx(0.5).epsilon(0.05));
}

TEST_CASE("occlusion: at the distance of its height a wall stops (1 - cos 45°) / 2 of the light") {
  // A long wall that rises to an angle e above the horizon stops the share sin²(e/2).
  CHECK(1 - Corner(2).at(2) == doctest::Approx(0.1464).epsilon(0.15));
}

TEST_CASE("occlusion: means are over texels of one surface") {
  std::vector<OccludedTexel> texels(64);
  std::vector<Index> owners(64, 0);
  for (Index i = 0; i < 64; ++i) {
    const bool isLeft = i % 8 < 4;
    owners[i] = isLeft ? 0 : 1;
    texels[i].place = Eigen::Vector3f(float(i % 8), float(i / 8), isLeft ? 0.0f : 1000.0f);
    texels[i].normal = Eigen::Vector3f::UnitZ();
    texels[i].open = isLeft ? 1.0f : 0.0f;
  }
  const std::vector<float> means = meansOver(texels, owners, 8);
  for (Index i = 0; i < 64; ++i) CHECK(means[i] == texels[i].open);
}
