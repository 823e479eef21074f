// SPDX-License-Identifier: MIT
#include "original/curves/seams.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace remesher;

namespace {

constexpr int kCells = 8;
constexpr double kPi = std::numbers::pi;

// A flat sheet whose texture coordinates follow from each vertex's place.
template <class Texture>
TriangleMesh sheet(Texture texture) {
  TriangleMesh mesh;
  Attribute uv{"TEXCOORD_0", 2, {}};
  for (int y = 0; y <= kCells; ++y)
    for (int x = 0; x <= kCells; ++x) {
      mesh.positions.emplace_back(x, y, 0);
      const Vec2 at = texture(double(x), double(y));
      uv.values.insert(uv.values.end(), {float(at.x()), float(at.y())});
    }
  for (Index y = 0; y < kCells; ++y)
    for (Index x = 0; x < kCells; ++x) {
      const Index a = y * (kCells + 1) + x, b = a + kCells + 1;
      mesh.indices.insert(mesh.indices.end(), {a, a + 1, b + 1, a, b + 1, b});
    }
  mesh.attributes.push_back(std::move(uv));
  return mesh;
}

}  // namespace

TEST_CASE("seams: a texture turns back along the middle of a mirrored sheet, and nowhere else") {
  const TriangleMesh input =
      sheet([](double x, double y) { return Vec2(std::abs(x - kCells / 2), y); });
  const BuiltMesh built = buildMesh(input);
  const Seams seams = findSeams(built, input, 40);
  CHECK(seams.edges.size() == kCells);
  CHECK(seams.jumps.empty());
  for (const Halfedge h : seams.edges)
    for (const Vertex v : {built.mesh.origin(h), built.mesh.tip(h)})
      CHECK(built.positions[v].x() == kCells / 2);
}

TEST_CASE("seams: a texture laid on in one piece has none, from either side") {
  for (const double way : {1.0, -1.0}) {
    const TriangleMesh input =
        sheet([&](double x, double y) { return Vec2(way * x + 0.1 * y * y, y); });
    CHECK(findSeams(buildMesh(input), input, 40).edges.empty());
  }
}

TEST_CASE("seams: around poles only the meridian where a grid's texture ends is left") {
  constexpr int kAround = 12, kDown = 6;
  TriangleMesh ball;
  Attribute uv{"TEXCOORD_0", 2, {}};
  for (int y = 0; y <= kDown; ++y)
    for (int x = 0; x <= kAround; ++x) {
      const double down = kPi * y / kDown, turn = 2 * kPi * (x % kAround) / kAround;
      const double across = y % kDown == 0 ? 0 : std::sin(down);
      ball.positions.emplace_back(across * std::cos(turn), across * std::sin(turn), std::cos(down));
      const bool isPole = y % kDown == 0;
      uv.values.insert(uv.values.end(), {float(x + (isPole ? 0.5 : 0)) / kAround, float(y)});
    }
  for (Index y = 0; y < kDown; ++y)
    for (Index x = 0; x < kAround; ++x) {
      const Index a = y * (kAround + 1) + x, b = a + kAround + 1;
      if (y > 0) ball.indices.insert(ball.indices.end(), {a, b, a + 1});
      if (y + 1 < kDown) ball.indices.insert(ball.indices.end(), {a + 1, b, b + 1});
    }
  ball.attributes.push_back(std::move(uv));
  const BuiltMesh built = buildMesh(ball);
  const Seams all = findSeams(built, ball, 40), left = findSeams(built, ball, 40, Poles::Left);
  CHECK(all.edges.size() == kDown + 2 * (kAround - 1));
  CHECK(left.edges.size() == kDown);
  CHECK(left.jumps == all.jumps);
  for (const Halfedge h : left.edges)
    for (const Vertex v : {built.mesh.origin(h), built.mesh.tip(h)})
      CHECK(std::abs(built.positions[v].y()) < 1e-12);
}
