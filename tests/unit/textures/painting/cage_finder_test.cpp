// SPDX-License-Identifier: MIT
#include "textures/painting/cage_finder.h"

#include <doctest/doctest.h>

using namespace remesher;

namespace {

// Squares across x and y at these heights; those at negative heights face down.
TriangleMesh sheetsAt(const std::vector<double>& heights) {
  TriangleMesh mesh;
  for (const double z : heights) {
    const Index first = Index(mesh.positions.size());
    for (const Vec2& p : {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)})
      mesh.positions.emplace_back(p.x(), p.y(), z);
    for (const Index v : {0, 1, 2, 0, 2, 3}) mesh.indices.push_back(first + v);
    if (z < 0)
      for (std::size_t i = mesh.indices.size() - 6; i < mesh.indices.size(); i += 3)
        std::swap(mesh.indices[i], mesh.indices[i + 1]);
  }
  return mesh;
}

// The height of what is found from a point, or 100.
double heightFrom(const std::vector<double>& heights, const Vec3& point, double cage) {
  const TriangleMesh mesh = sheetsAt(heights);
  const PaintSource source({&mesh, {}, {}, Unshaded::Flat});
  CageFinder finder(source, cage);
  const auto place = finder.placeFor(point, Vec3::UnitZ());
  return place ? source.position(*place).z() : 100;
}

}  // namespace

TEST_CASE("cage finder: the nearest sheet that faces the same way, above or below") {
  CHECK(heightFrom({0.3, 0.05, 0.9}, {0.4, 0.3, 0.1}, 0.5) == doctest::Approx(0.05));
  CHECK(heightFrom({0.3, 0.05, 0.9}, {0.4, 0.3, 0.2}, 0.5) == doctest::Approx(0.3));
  CHECK(heightFrom({0.3, -0.05}, {0.4, 0.3, 0}, 0.5) == doctest::Approx(0.3));
}

TEST_CASE("cage finder: nothing is found beyond the cage") {
  CHECK(heightFrom({0.3}, {0.4, 0.3, 0.1}, 0.1) == 100);
  CHECK(heightFrom({0.3}, {0.4, 0.3, 0.1}, 0.21) == doctest::Approx(0.3));
}

TEST_CASE("cage finder: beside the sheets the nearest place counts") {
  CHECK(heightFrom({0.3}, {1.05, 0.3, 0.3}, 0.1) == doctest::Approx(0.3));
  CHECK(heightFrom({0.3}, {1.2, 0.3, 0.3}, 0.1) == 100);
}
