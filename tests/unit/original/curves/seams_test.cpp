// SPDX-License-Identifier: MIT
#include "original/curves/seams.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace remesher;

namespace {

constexpr int kCells = 8;

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
