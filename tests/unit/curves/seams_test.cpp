// SPDX-License-Identifier: MIT
#include "curves/seams.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace remesher;

namespace {

constexpr int kSide = 8;

// A flat sheet whose texture coordinates follow from each vertex's place.
template <class Texture>
TriangleMesh sheet(Texture texture) {
  TriangleMesh mesh;
  Attribute uv{"TEXCOORD_0", 2, {}};
  for (int y = 0; y <= kSide; ++y)
    for (int x = 0; x <= kSide; ++x) {
      mesh.positions.emplace_back(x, y, 0);
      const Vec2 at = texture(double(x), double(y));
      uv.values.insert(uv.values.end(), {float(at.x()), float(at.y())});
    }
  for (Index y = 0; y < kSide; ++y)
    for (Index x = 0; x < kSide; ++x) {
      const Index a = y * (kSide + 1) + x, b = a + kSide + 1;
      mesh.indices.insert(mesh.indices.end(), {a, a + 1, b + 1, a, b + 1, b});
    }
  mesh.attributes.push_back(std::move(uv));
  return mesh;
}

}  // namespace

TEST_CASE("seams: a texture turns back along the middle of a mirrored sheet, and nowhere else") {
  const TriangleMesh input =
      sheet([](double x, double y) { return Vec2(std::abs(x - kSide / 2), y); });
  const BuiltMesh built = buildMesh(input);
  const Seams seams = findSeams(built, input, 40);
  CHECK(seams.edges.size() == kSide);
  CHECK(seams.jumps.empty());
  for (const Halfedge h : seams.edges)
    for (const Vertex v : {built.mesh.origin(h), built.mesh.tip(h)})
      CHECK(built.positions[v].x() == kSide / 2);
}

TEST_CASE("seams: a texture laid on in one piece has none, from either side") {
  for (const double way : {1.0, -1.0}) {
    const TriangleMesh input =
        sheet([&](double x, double y) { return Vec2(way * x + 0.1 * y * y, y); });
    CHECK(findSeams(buildMesh(input), input, 40).edges.empty());
  }
}
