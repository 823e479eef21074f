// SPDX-License-Identifier: MIT
#include "repair/pieces.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "measure/self_intersections.h"
#include "support/hostile_shapes.h"
#include "support/shapes.h"
#include "support/soups.h"

using namespace remesher;

namespace {

Pieces of(const TriangleMesh& mesh) {
  return piecesOf(buildMesh(mesh), std::vector<char>(mesh.triangleCount(), 0));
}

TriangleMesh scaled(TriangleMesh mesh, double factor) {
  for (Vec3& p : mesh.positions) p *= factor;
  return mesh;
}

}  // namespace

TEST_CASE("pieces: what faces into the solid around it is a cavity, what faces out a shell") {
  const TriangleMesh ball = shapes::icosphere(3);
  for (const bool isTurned : {false, true}) {
    const auto as = [&](const TriangleMesh& mesh) {
      return isTurned ? shapes::turnedOver(mesh) : mesh;
    };
    const Pieces hollow = of(soups::joined({as(ball), as(shapes::turnedOver(scaled(ball, 0.5)))}));
    CHECK(hollow.pieces[0].kind == SurfacePiece::Kind::Solid);
    CHECK(hollow.pieces[1].kind == SurfacePiece::Kind::Cavity);
    CHECK(hollow.pieces[0].isInsideOut == isTurned);
    CHECK(hollow.pieces[1].isInsideOut == isTurned);
    const Pieces nested = of(soups::joined({as(scaled(ball, 0.5)), as(ball)}));
    CHECK(nested.pieces[0].kind == SurfacePiece::Kind::Shell);
    CHECK(nested.pieces[1].kind == SurfacePiece::Kind::Solid);
  }
}

TEST_CASE("pieces: a body that lies loose in a cavity is a solid") {
  const TriangleMesh ball = shapes::icosphere(3);
  const Pieces pieces =
      of(soups::joined({ball, shapes::turnedOver(scaled(ball, 0.6)), scaled(ball, 0.3)}));
  CHECK(pieces.pieces[1].kind == SurfacePiece::Kind::Cavity);
  CHECK(pieces.pieces[2].kind == SurfacePiece::Kind::Solid);
  CHECK(!pieces.pieces[2].isInsideOut);
}

TEST_CASE("pieces: one with a boundary is open, and lies in nothing") {
  TriangleMesh open = scaled(shapes::icosphere(3), 0.5);
  open.indices.resize(open.indices.size() - 3);
  const Pieces pieces = of(soups::joined({shapes::icosphere(3), open}));
  CHECK(pieces.pieces[0].kind == SurfacePiece::Kind::Solid);
  CHECK(pieces.pieces[1].kind == SurfacePiece::Kind::Open);
}

TEST_CASE("pieces: a cavity that touches the wall in a point is one, from whichever corner on") {
  const TriangleMesh body = soups::cube(-1, 1);
  TriangleMesh cavity = shapes::turnedOver(soups::cube(0.25, 1));
  for (Vec3& p : cavity.positions)
    if (p != Vec3::Ones()) p *= 0.5;
  for (std::size_t first = 0; first < cavity.indices.size(); ++first) {
    TriangleMesh begun = cavity;
    const auto all = begun.indices.begin();
    for (std::size_t t = 0; t < cavity.triangleCount(); ++t)
      std::rotate(all + std::ptrdiff_t(3 * t), all + std::ptrdiff_t(3 * t + first % 3),
                  all + std::ptrdiff_t(3 * t + 3));
    std::rotate(all, all + std::ptrdiff_t(first / 3 * 3), begun.indices.end());
    const Pieces pieces = of(soups::joined({body, begun}));
    REQUIRE(pieces.pieces.size() == 2);
    CHECK(pieces.pieces[1].kind == SurfacePiece::Kind::Cavity);
    CHECK(!pieces.pieces[1].isInsideOut);
  }
}

TEST_CASE("pieces: a cavity that meets the wall with few of its faces is one; a body is a body") {
  const TriangleMesh wall = shapes::icosphere(5), small = scaled(shapes::icosphere(6), 0.4);
  const auto kindOf = [&](const TriangleMesh& inner, double shift) {
    const TriangleMesh mesh = soups::joined({wall, soups::moved(inner, Vec3(shift, 0, 0))});
    std::vector<char> isCrossed(mesh.triangleCount(), 0);
    for (const Index t : selfIntersections(mesh)) isCrossed[t] = 1;
    REQUIRE(isCrossed != std::vector<char>(mesh.triangleCount(), 0));
    const SurfacePiece piece = piecesOf(buildMesh(mesh), isCrossed).pieces[1];
    return std::pair(piece.kind, piece.isInsideOut);
  };
  using Kind = SurfacePiece::Kind;
  CHECK(kindOf(shapes::turnedOver(small), 0.6) == std::pair(Kind::Cavity, false));
  CHECK(kindOf(shapes::turnedOver(small), 0.9) == std::pair(Kind::Solid, true));
  CHECK(kindOf(small, 0.6) == std::pair(Kind::Solid, false));
}
