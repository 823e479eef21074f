// SPDX-License-Identifier: MIT
#include "repair/loose_pieces.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "support/shapes.h"
#include "support/soups.h"

using namespace remesher;

namespace {

TriangleMesh ballAt(const Vec3& centre, double radius, int n = 2) {
  TriangleMesh ball = shapes::icosphere(n);
  for (Vec3& p : ball.positions) p = centre + radius * p;
  return ball;
}

std::vector<char> floatersOf(const TriangleMesh& mesh) {
  return LoosePieces(mesh.positions, mesh.indices).floaters();
}

}  // namespace

TEST_CASE("loose pieces: they have sizes, areas and triangles") {
  const TriangleMesh mesh = soups::joined({soups::cube(0, 2), soups::cube(5, 6)});
  const LoosePieces pieces(mesh.positions, mesh.indices);
  REQUIRE(pieces.all().size() == 2);
  CHECK(pieces.all()[0].area == doctest::Approx(24));
  CHECK(pieces.all()[1].across() == doctest::Approx(std::sqrt(3)));
  CHECK(pieces.smallerThan(0.2) == std::vector<char>{0, 1});
  CHECK(pieces.smallerThan(0.1) == std::vector<char>{0, 0});
}

TEST_CASE("loose pieces: floaters are small and away from the rest") {
  const TriangleMesh body = ballAt({0, 0, 0}, 1, 6);
  const TriangleMesh speck = ballAt({1.2, 0, 0}, 0.01), other = ballAt({0, 1.1, 0.3}, 0.013, 1);
  CHECK(floatersOf(soups::joined({body, speck, other})) == std::vector<char>{0, 1, 1});
  const TriangleMesh wart = ballAt({1, 0, 0}, 0.02);  // intersects the body
  CHECK(floatersOf(soups::joined({body, wart})) == std::vector<char>{0, 0});
  const TriangleMesh large = ballAt({1.6, 0, 0}, 0.2);
  CHECK(floatersOf(soups::joined({body, large})) == std::vector<char>{0, 0});
}

TEST_CASE("loose pieces: many floaters of one area are no kind") {
  TriangleMesh mesh = ballAt({0, 0, 0}, 1, 6);
  for (int k = 0; k < 4; ++k) {
    TriangleMesh speck = ballAt({0, 0, 0}, 1, 1);
    for (Vec3& p : speck.positions) p.x() *= 1 + 0.2 * k;
    const double size = 0.01 / std::sqrt(LoosePieces(speck.positions, speck.indices).all()[0].area);
    for (Vec3& p : speck.positions) p = size * p + 1.2 * shapes::onCircle(k, 4);
    mesh = soups::joined({mesh, speck});
  }
  CHECK(floatersOf(mesh) == std::vector<char>{0, 1, 1, 1, 1});
}

TEST_CASE("loose pieces: three of a kind are meant, and so are pieces that make up the model") {
  TriangleMesh studded = ballAt({0, 0, 0}, 1, 6);
  for (int k = 0; k < 4; ++k)
    studded = soups::joined({studded, ballAt(1.2 * shapes::onCircle(k, 4), 0.01)});
  const std::vector<char> isFloater = floatersOf(studded);
  CHECK(std::count(isFloater.begin(), isFloater.end(), 1) == 0);
  TriangleMesh cloud;
  for (int k = 0; k < 60; ++k)
    cloud = soups::joined(
        {cloud, ballAt(shapes::onCircle(k, 60) * (1 + 0.1 * (k % 7)), 0.004 + 0.0002 * k, 1)});
  const std::vector<char> isOfCloud = floatersOf(cloud);
  CHECK(std::count(isOfCloud.begin(), isOfCloud.end(), 1) == 0);
}
