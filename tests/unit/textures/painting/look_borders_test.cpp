// SPDX-License-Identifier: MIT
#include "textures/painting/look_borders.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/triangle.h"
#include "squares.h"

using namespace remesher;
using namespace remesher::test;

namespace {

// A part of the original, from one x to another, with the greys that it has there.
struct Strip {
  double from, to;
  float greyFrom, greyTo;
};

// Two squares side by side, the second turned up about their common edge at x = 1; the original
// lies where they do, cut into strips.
struct Hinge {
  TriangleMesh mesh, original;
  std::vector<InputPlace> places;
  std::unique_ptr<PaintSource> source;

  Hinge(double angle, const std::vector<Strip>& strips) : angle_(angle) {
    Attribute colors{"COLOR_0", 3, {}};
    for (const auto& [from, to, greyFrom, greyTo] : strips) {
      if (from < 1) turned_ += 2;
      add(original, from, to);
      for (const float grey : {greyFrom, greyTo, greyTo, greyFrom})
        colors.values.insert(colors.values.end(), 3, grey);
    }
    original.attributes.push_back(colors);
    source = sourceOf(original);
    for (const double x : {0., 1.}) add(mesh, x, x + 1);
    for (Index h = 0; h < mesh.indices.size(); ++h) places.push_back(placeOf(h));
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
  void add(TriangleMesh& to, double from, double end) const {
    addSquare(to, 0, Facing::Up);
    for (std::size_t v = to.positions.size() - 4; v < to.positions.size(); ++v) {
      Vec3& p = to.positions[v];
      const double x = from + p.x() * (end - from), out = std::max(x - 1, 0.0);
      p = Vec3(x - out + out * std::cos(angle_), p.y(), out * std::sin(angle_));
    }
  }

  // The nearest on the side of the hinge where the corner's triangle is.
  InputPlace placeOf(Index h) const {
    const Vec3& p = mesh.positions[mesh.indices[h]];
    InputPlace best{InputTriangle(0), Vec3::Zero()};
    double least = 1e300;
    for (Index t = 0; t < original.triangleCount(); ++t) {
      const Triangle c = source->corners(InputTriangle(t));
      const Vec3 weights = closestBarycentric(p, c[0], c[1], c[2]);
      const double distance =
          (weights[0] * c[0] + weights[1] * c[1] + weights[2] * c[2] - p).norm();
      if ((t >= turned_) != (h >= 6) || distance >= least) continue;
      least = distance;
      best = {InputTriangle(t), weights};
    }
    return best;
  }

  double angle_;
  Index turned_ = 0;  // the first triangle of the original beyond the edge
};

std::vector<Strip> greys(float a, float b, float c, float d) {
  return {{0, 1, a, b}, {1, 2, c, d}};
}

constexpr double kTexel = 0.01, kLargeTexel = 1;
constexpr std::array<bool, 2> kHinge = {true, false}, kNothing = {false, false};

}  // namespace

TEST_CASE("look borders: where the colour jumps, not where it only changes") {
  CHECK(Hinge(0, greys(0.2f, 0.2f, 0.8f, 0.8f)).marked(kTexel) == kHinge);
  CHECK(Hinge(0, greys(0.2f, 0.5f, 0.5f, 0.8f)).marked(kTexel) == kNothing);
  CHECK(Hinge(0, greys(0.5f, 0.5f, 0.5f, 0.5f)).marked(kTexel) == kNothing);
  CHECK(Hinge(0, greys(0.5f, 0.5f, 0.55f, 0.55f)).marked(kTexel) == kNothing);
}

TEST_CASE("look borders: not where something painted changes, however fast, beside the edge") {
  for (const double width : {0.3, 1.0, 1.8}) {
    const double from = 1 - width * kTexel / 2, to = 1 + width * kTexel / 2;
    CHECK(Hinge(0, {{0, from, 0.2f, 0.2f},
                    {from, 1, 0.2f, 0.5f},
                    {1, to, 0.5f, 0.8f},
                    {to, 2, 0.8f, 0.8f}})
              .marked(kTexel) == kNothing);
  }
}

TEST_CASE("look borders: where the jump is, and not beside it") {
  const auto jumpAt = [](double x) {
    return Hinge(0, {{0, 1, 0.2f, 0.2f}, {1, x, 0.2f, 0.2f}, {x, 2, 0.8f, 0.8f}});
  };
  CHECK(jumpAt(1 + 0.2 * kTexel).marked(kTexel) == kHinge);
  CHECK(jumpAt(1 + 0.8 * kTexel).marked(kTexel) == kNothing);
}

TEST_CASE("look borders: where normals part") {
  CHECK(Hinge(std::numbers::pi / 2, greys(0.5f, 0.5f, 0.5f, 0.5f)).marked(kTexel) == kHinge);
  CHECK(Hinge(std::numbers::pi / 18, greys(0.5f, 0.5f, 0.5f, 0.5f)).marked(kTexel) == kNothing);
}

TEST_CASE("look borders: none where triangles are as small as texels") {
  CHECK(Hinge(0, greys(0.2f, 0.2f, 0.8f, 0.8f)).marked(kLargeTexel) == kNothing);
}
