// SPDX-License-Identifier: MIT
#include "repair/body_mesh.h"

#include <doctest/doctest.h>

#include <array>

#include "repair/pieces.h"
#include "support/soups.h"

using namespace remesher;

namespace {

constexpr std::array<std::array<double, 2>, 5> kSquare = {
    {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}, {1, 1}}};

Vec3 corner(std::size_t side, double width, double height) {
  return {width * kSquare[side][0], width * kSquare[side][1], height};
}

// A flat octahedron, and a frame around it whose sharp inner rim is the octahedron's.
TriangleMesh lensInFrame(double height) {
  TriangleMesh mesh;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3 one = corner(i, 1, 0), next = corner(i + 1, 1, 0);
    soups::addTriangle(mesh, {0, 0, height}, one, next);
    soups::addTriangle(mesh, {0, 0, -height}, next, one);
    const Vec3 above = corner(i, 2, height), nextAbove = corner(i + 1, 2, height),
               below = corner(i, 2, -height), nextBelow = corner(i + 1, 2, -height);
    soups::addQuad(mesh, {one, above, nextAbove, next});
    soups::addQuad(mesh, {one, next, nextBelow, below});
    soups::addQuad(mesh, {below, nextBelow, nextAbove, above});
  }
  return mesh;
}

}  // namespace

TEST_CASE("body mesh: bodies that touch along edges are pieces of their own, however thin") {
  for (const double height : {0.5, 1e-3, 1e-9}) {
    const TriangleMesh mesh = lensInFrame(height);
    const BuiltMesh built = buildBodies(mesh);
    const Pieces pieces = piecesOf(built, std::vector<char>(mesh.triangleCount(), 0));
    REQUIRE(pieces.pieces.size() == 2);
    for (const SurfacePiece& piece : pieces.pieces) {
      CHECK(piece.kind == SurfacePiece::Kind::Solid);
      CHECK(!piece.isInsideOut);
    }
    CHECK(pieces.pieces[0].faces == 8);
    CHECK(pieces.pieces[1].faces == 24);
  }
}
