// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>

#include "remesher.h"

using namespace remesher;

namespace {

// A unit ball: the sides of a cube, divided n times each, pushed out. Red where x > 0, else blue.
TriangleMesh ballOf(Index n) {
  TriangleMesh mesh;
  Attribute colors{"COLOR_0", 3, {}};
  for (int side = 0; side < 6; ++side) {
    const int axis = side / 2;
    const double sign = side % 2 == 0 ? 1 : -1;
    const Index first = Index(mesh.positions.size());
    for (Index i = 0; i < (n + 1) * (n + 1); ++i) {
      Vec3 p;
      p[axis] = sign;
      p[(axis + 1) % 3] = sign * (2.0 * (i % (n + 1)) / n - 1);
      p[(axis + 2) % 3] = 2.0 * (i / (n + 1)) / n - 1;
      mesh.positions.push_back(p.normalized());
      for (const float c : {p.x() > 0 ? 1.f : 0.f, 0.f, p.x() > 0 ? 0.f : 1.f})
        colors.values.push_back(c);
    }
    for (Index y = 0; y < n; ++y)
      for (Index x = 0; x < n; ++x) {
        const Index a = first + y * (n + 1) + x, d = a + n + 1;
        for (const Index v : {a, a + 1, d + 1, a, d + 1, d}) mesh.indices.push_back(v);
      }
  }
  mesh.attributes.push_back(std::move(colors));
  return mesh;
}

}  // namespace

TEST_CASE("bake: of arrays, a ball onto a coarser one") {
  TriangleMesh low = ballOf(4);
  low.attributes.clear();
  RemeshOptions options;
  options.textureSize = 256;
  const BakeResult result = bake(ballOf(32), low, options);
  REQUIRE(result.report.atlas);
  CHECK(result.report.atlas->notFound < 1);
  CHECK(!result.report.atlas->isGiven);
  CHECK(result.report.output->triangles == low.triangleCount());
  const TriangleMesh& made = result.mesh;
  const Attribute& texcoords = *findAttribute(made, "TEXCOORD_0");
  REQUIRE(!result.maps.empty());
  CHECK(result.maps.front().name == "baseColor");
  const Picture& map = result.maps.front();
  std::size_t wrong = 0, count = 0;
  for (std::size_t t = 0; t < made.triangleCount(); ++t) {
    Vec3 middle = Vec3::Zero();
    Vec2 at = Vec2::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t v = made.indices[3 * t + k];
      middle += made.positions[v] / 3;
      at += Vec2(texcoords.values[2 * v], texcoords.values[2 * v + 1]) / 3;
    }
    if (std::abs(middle.x()) < 0.15) continue;
    const auto texel = Index(at.y() * map.height) * map.width + Index(at.x() * map.width);
    ++count;
    wrong += (map.texels[4 * std::size_t{texel}] > 127) != (middle.x() > 0);
  }
  CHECK(count > 100);
  CHECK(wrong == 0);
}

TEST_CASE("bake: bakes of files are written as glTF only") {
  CHECK_THROWS_AS(bakeFiles({}, {}, "low.obj", {}), Error);
}

TEST_CASE("unwrap: of files, formats without texture coordinates are refused") {
  CHECK_THROWS_AS(unwrapFile({}, "part.stl", {}), Error);
}

TEST_CASE("unwrap: files get texture coordinates in any format, even their own without any") {
  const auto textOf = [](const std::string& given, const std::string& name) {
    const File file{name, {given.begin(), given.end()}};
    const RemeshFileResult run = unwrapFile({file, {}}, name, {});
    const auto& bytes = run.files.front().bytes;
    return std::string(bytes.begin(), bytes.end());
  };
  const auto has = [](const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
  };
  const std::string obj =
      textOf("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n", "a.obj");
  CHECK(has(obj, "\nvt "));
  CHECK(has(obj, "f 1/1"));
  const std::string ply = textOf(
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
      "z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 "
      "0\n0 "
      "0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n",
      "a.ply");
  CHECK(has(ply, "ascii"));
  CHECK(has(ply, "property float s\n"));
  CHECK(has(textOf("OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n",
                   "a.off"),
            "STOFF"));
}

TEST_CASE("unwrap: of arrays, the same triangles") {
  const TriangleMesh ball = ballOf(4);
  const UnwrapResult result = unwrap(ball, {});
  REQUIRE(result.mesh.indices.size() == ball.indices.size());
  for (std::size_t h = 0; h < ball.indices.size(); ++h)
    CHECK(result.mesh.positions[result.mesh.indices[h]] == ball.positions[ball.indices[h]]);
  CHECK(result.report.atlas->coverage > 40);
  CHECK(result.report.atlas->worstStretch < 2);
}
