// SPDX-License-Identifier: MIT
#include "textures/charts/atlas_figures.h"

#include <doctest/doctest.h>

#include <vector>

using namespace remesher;

namespace {

// Two triangles of a unit square, laid out by a function of x and y.
template <class Map>
AtlasFigures figuresUnder(const Map& map) {
  const std::vector<Vec3> places = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<Index> welded = {0, 1, 2, 0, 2, 3};
  std::vector<Vec3> positions;
  std::vector<Vec2> texcoords;
  for (std::size_t i = 0; i < welded.size(); ++i) {
    positions.push_back(places[welded[i]]);
    texcoords.push_back(map(positions[i].x(), positions[i].y(), i / 3));
  }
  return figuresOf({positions, welded, texcoords});
}

}  // namespace

TEST_CASE("atlas figures: a smaller copy stretches nothing") {
  const AtlasFigures f =
      figuresUnder([](double x, double y, std::size_t) { return Vec2(x / 2, y / 2); });
  CHECK(f.charts == 1);
  CHECK(f.coverage == doctest::Approx(0.25));
  CHECK(f.stretch == doctest::Approx(1));
  CHECK(f.worstStretch == doctest::Approx(1));
  CHECK(f.overlap == 0);
  CHECK(f.unusable == 0);
}

TEST_CASE("atlas figures: a map of half the height stretches by the root of two at most") {
  const AtlasFigures f =
      figuresUnder([](double x, double y, std::size_t) { return Vec2(x, y / 2); });
  CHECK(f.worstStretch == doctest::Approx(std::sqrt(2.0)));  // even: 1/√2 texels per length
  CHECK(f.stretch == doctest::Approx(std::sqrt(1.25)));      // √((1/2 + 2) / 2)
}

TEST_CASE("atlas figures: triangles on one place overlap, and are two charts") {
  const AtlasFigures f = figuresUnder(
      [](double x, double y, std::size_t t) { return t == 0 ? Vec2(x, y) : Vec2(y, x); });
  CHECK(f.charts == 2 - 1);  // they agree on the diagonal
  CHECK(f.overlap > 0.99);
}

TEST_CASE("atlas figures: what crosses the border of the square cannot be used") {
  const AtlasFigures f = figuresUnder(
      [](double x, double y, std::size_t t) { return Vec2(x + (t == 1 ? 3.5 : 0), y); });
  CHECK(f.charts == 2);
  CHECK(f.unusable == doctest::Approx(0.5));
}

TEST_CASE("atlas figures: maps repeat, so that all of a next square is as good") {
  const AtlasFigures f =
      figuresUnder([](double x, double y, std::size_t) { return Vec2(x - 2, y + 1); });
  CHECK(f.unusable == 0);
  CHECK(f.coverage == doctest::Approx(1));
  CHECK(f.overlap == 0);
}

TEST_CASE("atlas figures: roundings of single coordinates are no stretch, a flat needle is one") {
  const auto worst = [](double height) {
    std::vector<Vec3> positions = {
        {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, -height, 0}, {1, -height, 0}};
    positions.push_back({0.5, 0, 0});
    std::vector<Vec2> texcoords;
    for (const Vec3& p : positions) texcoords.emplace_back(p.x() / 2, 0.5 + p.y() / 2);
    texcoords.back().y() -= height / 4;
    const std::vector<Index> welded = {0, 1, 2, 3, 4, 5};
    return figuresOf({positions, welded, texcoords}).worstStretch;
  };
  CHECK(worst(1e-7) == doctest::Approx(1));
  CHECK(worst(1e-3) == doctest::Approx(2).epsilon(0.01));
}
