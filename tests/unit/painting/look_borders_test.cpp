// SPDX-License-Identifier: MIT
#include "painting/look_borders.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "squares.h"

using namespace remesher;
using namespace remesher::test;

namespace {

// Two squares side by side, the second turned up about their common edge, with a grey each: what
// their corners have at x = 0, 1 and 1, 2.
struct Hinge {
  TriangleMesh mesh;
  std::vector<InputPlace> places;
  std::unique_ptr<PaintSource> source;

  Hinge(double angle, std::array<float, 4> greys) {
    for (int i = 0; i < 2; ++i) {
      addSquare(mesh, 0, Facing::Up);
      for (Index v = Index(4 * i); v < 4 * (Index(i) + 1); ++v) {
        Vec3& p = mesh.positions[v];
        colors_.insert(colors_.end(), 3, greys[std::size_t(2 * i + (p.x() > 0.5))]);
        if (i == 1) p = Vec3(1 + p.x() * std::cos(angle), p.y(), p.x() * std::sin(angle));
      }
    }
    mesh.attributes.push_back({"COLOR_0", 3, colors_});
    for (Index h = 0; h < mesh.indices.size(); ++h)
      places.push_back({h / 3, Vec3::Unit(Eigen::Index(h % 3))});
    source = sourceOf(mesh);
  }

  // Whether each edge between two triangles is marked: the hinge, and whether any other.
  std::array<bool, 2> marked(double texel) const {
    const NewSurface surface(mesh, places, *source);
    const std::vector<char> borders = lookBorders(surface, *source, texel);
    std::array<bool, 2> result = {true, false};
    for (Index h = 0; h < borders.size(); ++h) {
      const Index next = h % 3 == 2 ? h - 2 : h + 1;
      const Vec3 middle = (surface.position(h) + surface.position(next)) / 2;
      if (middle.isApprox(Vec3(1, 0.5, 0)))
        result[0] &= borders[h] != 0;
      else
        result[1] |= borders[h] != 0;
    }
    return result;
  }

 private:
  std::vector<float> colors_;
};

constexpr double kTexel = 0.01, kLargeTexel = 1;
constexpr std::array<bool, 2> kHinge = {true, false}, kNothing = {false, false};

}  // namespace

TEST_CASE("look borders: where the colour jumps, not where it only changes") {
  CHECK(Hinge(0, {0.2f, 0.2f, 0.8f, 0.8f}).marked(kTexel) == kHinge);
  CHECK(Hinge(0, {0.2f, 0.5f, 0.5f, 0.8f}).marked(kTexel) == kNothing);
  CHECK(Hinge(0, {0.5f, 0.5f, 0.5f, 0.5f}).marked(kTexel) == kNothing);
}

TEST_CASE("look borders: where normals part") {
  CHECK(Hinge(std::numbers::pi / 2, {0.5f, 0.5f, 0.5f, 0.5f}).marked(kTexel) == kHinge);
  CHECK(Hinge(std::numbers::pi / 18, {0.5f, 0.5f, 0.5f, 0.5f}).marked(kTexel) == kNothing);
}

TEST_CASE("look borders: none where triangles are as small as texels") {
  CHECK(Hinge(0, {0.2f, 0.2f, 0.8f, 0.8f}).marked(kLargeTexel) == kNothing);
}
