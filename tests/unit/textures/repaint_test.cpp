// SPDX-License-Identifier: MIT
#include "textures/repaint.h"

#include <doctest/doctest.h>

#include <cstdint>

using namespace remesher;

namespace {

constexpr Index kTexels = 16;

// Red on the left half of the square, blue on the right.
io::NamedImage halves() {
  io::NamedImage named{"0", {kTexels, kTexels, {}}};
  for (Index i = 0; i < kTexels * kTexels; ++i) {
    const bool isLeft = i % kTexels < kTexels / 2;
    for (const int level : {isLeft ? 255 : 0, 0, isLeft ? 0 : 255, 255})
      named.image.texels.push_back(std::uint8_t(level));
  }
  return named;
}

// A bent sheet of n × n quads, two triangles each; its texture's columns follow x.
TriangleMesh sheet(Index n) {
  TriangleMesh mesh;
  Attribute texcoords{"TEXCOORD_0", 2, {}};
  for (Index i = 0; i < (n + 1) * (n + 1); ++i) {
    const double x = double(i % (n + 1)) / n, y = double(i / (n + 1)) / n;
    mesh.positions.emplace_back(x, y, (i % 2 == 0 ? 0.4 : 0.0) / n);
    for (const double u : {x, y}) texcoords.values.push_back(float(u));
  }
  for (Index y = 0; y < n; ++y)
    for (Index x = 0; x < n; ++x) {
      const Index a = y * (n + 1) + x, d = a + n + 1;
      for (const Index v : {a, a + 1, d + 1, a, d + 1, d}) mesh.indices.push_back(v);
    }
  mesh.attributes.push_back(std::move(texcoords));
  return mesh;
}

io::Model modelOf(TriangleMesh mesh) {
  io::Material look;
  look.baseColorMap.image = "0";
  io::Model model;
  model.parts.push_back({"sheet", std::move(mesh), {Transform::Identity()}, {{"paint", {}, look}}});
  return model;
}

std::vector<std::vector<InputPlace>> placesOf(const TriangleMesh& mesh) {
  std::vector<InputPlace> places;
  for (Index h = 0; h < mesh.indices.size(); ++h)
    places.push_back({InputTriangle{h / 3}, Vec3::Unit(Eigen::Index(h % 3))});
  return {places};
}

// The model painted at a size, its parts as they are, but for the height of their middle.
io::Model painted(io::Model model, std::vector<io::Part> given, RemeshOptions options = {},
                  double raised = 0) {
  const Repaint repaint(model, std::move(given), {halves()});
  const bool areQuads = model.parts.front().mesh.isQuads;
  model.parts = repaint.bareParts();
  model.parts.front().mesh.isQuads = areQuads;
  std::vector<Vec3>& positions = model.parts.front().mesh.positions;
  positions[positions.size() / 2].z() += raised;
  const TriangleMesh bare = model.parts.front().mesh;
  options.textureSize = 128;
  repaint.paint(model, placesOf(bare), options, {});
  return model;
}

}  // namespace

TEST_CASE("repaint: quads stay pairs of triangles that share two vertices") {
  TriangleMesh mesh = sheet(9);
  mesh.isQuads = true;
  const io::Model model = painted(modelOf(mesh), {});
  const TriangleMesh& made = model.parts.front().mesh;
  CHECK(made.isQuads);
  REQUIRE(made.indices.size() == mesh.indices.size());
  for (std::size_t i = 0; i < made.indices.size(); i += 6) {
    CHECK(made.indices[i + 3] == made.indices[i]);
    CHECK(made.indices[i + 4] == made.indices[i + 2]);
  }
}

TEST_CASE("repaint: paint comes from the parts as they were given, however repair mixed them") {
  io::Model model = modelOf(sheet(6));
  const std::vector<io::Part> given = model.parts;
  TriangleMesh& mended = model.parts.front().mesh;
  for (Vec3& p : mended.positions) p.z() += 1e-3;
  for (float& u : mended.attributes.front().values) u = 0.5;  // as in the middle between two charts
  const io::Model result = painted(std::move(model), given);
  const TriangleMesh& made = result.parts.front().mesh;
  const Attribute& texcoords = *findAttribute(made, "TEXCOORD_0");
  const io::Image& colors = result.images.front().image;
  for (std::size_t t = 0; t < made.triangleCount(); ++t) {
    Vec3 middle = Vec3::Zero();
    Vec2 at = Vec2::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t v = made.indices[3 * t + k];
      middle += made.positions[v] / 3;
      at += Vec2(texcoords.values[2 * v], texcoords.values[2 * v + 1]) / 3;
    }
    const auto texel = Index(at.y() * colors.height) * colors.width + Index(at.x() * colors.width);
    const bool isRed = colors.texels[4 * std::size_t{texel}] > 127;
    if (std::abs(middle.x() - 0.5) > 0.05) CHECK(isRed == (middle.x() < 0.5));
  }
}

TEST_CASE("repaint: triangles on the facets of a model without normals need no normals either") {
  const auto hasNormals = [](const io::Model& model) {
    const bool hasMap = bool(model.paintings.front().normalMap);
    CHECK(hasMap == (findAttribute(model.parts.front().mesh, "NORMAL") != nullptr));
    return hasMap;
  };
  const io::Model model = modelOf(sheet(6));
  CHECK(!hasNormals(painted(model, {})));
  CHECK(hasNormals(painted(model, {}, {}, 0.1)));
  RemeshOptions levels;
  levels.lods = {0.5};
  CHECK(hasNormals(painted(model, {}, levels)));
}
