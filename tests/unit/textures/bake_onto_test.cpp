// SPDX-License-Identifier: MIT
#include "textures/bake_onto.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace remesher;

namespace {

constexpr double kHeight = 0.02, kWaves = 2;

double heightAt(double x) { return kHeight * std::sin(2 * std::numbers::pi * kWaves * x); }
double slopeAt(double x) {
  return kHeight * 2 * std::numbers::pi * kWaves * std::cos(2 * std::numbers::pi * kWaves * x);
}

// A unit square of n × n quads with waves along x; its colour is x, y, 0.
TriangleMesh wavySheet(Index n, double height) {
  TriangleMesh mesh;
  Attribute colors{"COLOR_0", 3, {}};
  for (Index i = 0; i < (n + 1) * (n + 1); ++i) {
    const double x = double(i % (n + 1)) / n, y = double(i / (n + 1)) / n;
    mesh.positions.emplace_back(x, y, height * heightAt(x) / kHeight);
    for (const double c : {x, y, 0.0}) colors.values.push_back(float(c));
  }
  for (Index y = 0; y < n; ++y)
    for (Index x = 0; x < n; ++x) {
      const Index a = y * (n + 1) + x, d = a + n + 1;
      for (const Index v : {a, a + 1, d + 1, a, d + 1, d}) mesh.indices.push_back(v);
    }
  if (height > 0) mesh.attributes.push_back(std::move(colors));
  return mesh;
}

// A flat square of two triangles; u = x, v = 1 - y, as glTF counts.
TriangleMesh flatSquare() {
  TriangleMesh mesh = wavySheet(1, 0);
  Attribute texcoords{"TEXCOORD_0", 2, {}};
  for (const Vec3& p : mesh.positions)
    for (const double c : {p.x(), 1 - p.y()}) texcoords.values.push_back(float(c));
  mesh.attributes.push_back(std::move(texcoords));
  return mesh;
}

struct Baked {
  io::Model model;
  AtlasReport report;
};

Baked bakedOnto(TriangleMesh low, const TriangleMesh& high, RemeshOptions options = {}) {
  Baked baked;
  baked.model.parts.push_back({"low", std::move(low), {Transform::Identity()}});
  if (!options.textureSize) options.textureSize = 64;
  options.cage = options.cage.value_or(5);
  const BakeOriginals from{
      {io::Part{"high", high, {Transform::Identity()}}}, {0}, {}, Unshaded::Smooth};
  baked.report = bakeOnto(baked.model, from, options, {});
  return baked;
}

const io::Image& mapOf(const Baked& baked, const std::string& name) {
  for (const io::PaintedImage& image : baked.model.images)
    if (image.name == name) return image.image;
  FAIL("there is no map " << name);
  return baked.model.images.front().image;
}

Vec3 directionAt(const io::Image& map, Index column, Index row) {
  const std::uint8_t* const texel = &map.texels[4 * (std::size_t{row} * map.width + column)];
  return (Vec3(texel[0], texel[1], texel[2]) / 127.5 - Vec3::Ones()).normalized();
}

}  // namespace

TEST_CASE("bake onto: the normal map of waves has their normals") {
  const Baked baked = bakedOnto(flatSquare(), wavySheet(128, kHeight));
  CHECK(baked.report.isGiven);
  CHECK(baked.report.notFound == 0);
  const io::Image& map = mapOf(baked, "normal");
  for (Index row = 2; row < 62; row += 7)
    for (Index column = 2; column < 62; ++column) {
      const double x = (column + 0.5) / 64;
      const Vec3 expected = Vec3(-slopeAt(x), 0, 1).normalized();
      CHECK((directionAt(map, column, row) - expected).norm() < 0.02);
    }
}

TEST_CASE("bake onto: colours of vertices become a base colour") {
  const Baked baked = bakedOnto(flatSquare(), wavySheet(64, kHeight));
  const io::Image& map = mapOf(baked, "baseColor");
  for (Index i = 3; i < 61; ++i) {
    const std::uint8_t* const texel = &map.texels[4 * (std::size_t{i} * 64 + i)];
    const double light = (i + 0.5) / 64;
    const double srgb = 255 * (1.055 * std::pow(light, 1 / 2.4) - 0.055);
    CHECK(std::abs(texel[0] - srgb) < 3);
    const double down = 1 - light, other = 255 * (1.055 * std::pow(down, 1 / 2.4) - 0.055);
    CHECK(std::abs(texel[1] - other) < 3);
  }
}

TEST_CASE("bake onto: vertices, triangles and given texture coordinates stay") {
  const TriangleMesh low = flatSquare();
  const Baked baked = bakedOnto(low, wavySheet(16, kHeight));
  const TriangleMesh& made = baked.model.parts.front().mesh;
  CHECK(made.positions == low.positions);
  CHECK(made.indices == low.indices);
  CHECK(findAttribute(made, "TEXCOORD_0")->values == findAttribute(low, "TEXCOORD_0")->values);
  CHECK(findAttribute(made, "COLOR_0") == nullptr);
  CHECK(findAttribute(made, "TANGENT") != nullptr);
}

TEST_CASE("bake onto: a mirrored chart is painted like any other") {
  TriangleMesh low = flatSquare();
  for (std::size_t i = 0; i < low.attributes[0].values.size(); i += 2)
    low.attributes[0].values[i] = 1 - low.attributes[0].values[i];
  const Baked baked = bakedOnto(low, wavySheet(128, kHeight));
  CHECK(baked.report.isGiven);
  const io::Image& map = mapOf(baked, "normal");
  for (Index column = 2; column < 62; ++column) {
    const double x = 1 - (column + 0.5) / 64;  // along the tangent, which is turned over
    CHECK((directionAt(map, column, 30) - Vec3(slopeAt(x), 0, 1).normalized()).norm() < 0.02);
  }
}

TEST_CASE("bake onto: texture coordinates that overlap are replaced, which is said") {
  TriangleMesh low = flatSquare();
  for (float& u : low.attributes[0].values) u = u > 0.5f ? 0.9f : 0.4f;
  low.indices.insert(low.indices.end(), {0, 1, 2});  // a triangle twice
  const Baked baked = bakedOnto(low, wavySheet(16, kHeight));
  CHECK(!baked.report.isGiven);
  REQUIRE(!baked.model.warnings.empty());
  CHECK(baked.model.warnings.front().code == "TEXCOORDS_REPLACED");
}

TEST_CASE("bake onto: the share of texels for which nothing is found is said") {
  TriangleMesh low = flatSquare();
  for (Vec3& p : low.positions) p.x() *= 2;  // half of it has nothing above or below
  RemeshOptions options;
  options.cage = 2;
  const Baked baked = bakedOnto(low, wavySheet(32, kHeight), options);
  CHECK(baked.report.notFound == doctest::Approx(50).epsilon(0.06));
  CHECK(baked.model.warnings.back().code == "TEXELS_NOT_FOUND");
}

TEST_CASE("bake onto: occlusion is painted where it is asked for") {
  RemeshOptions options;
  options.ao = true;
  const Baked baked = bakedOnto(flatSquare(), wavySheet(64, 0.1), options);
  CHECK(bool(baked.model.paintings.front().occlusionMap));
  const io::Image& map = mapOf(baked, "surface");
  const auto open = [&](double x) {
    return int(map.texels[4 * (std::size_t{32} * 64 + std::size_t(64 * x))]);
  };
  CHECK(open(0.125) > open(0.375) + 20);  // a crest, and the trough behind it
  for (const io::PaintedImage& image : bakedOnto(flatSquare(), wavySheet(64, 0.1)).model.images)
    CHECK(image.name != "surface");
}

TEST_CASE("bake onto: symmetric meshes give symmetric maps") {
  RemeshOptions options;
  options.textureSize = 64;
  const Baked baked = bakedOnto(flatSquare(), wavySheet(64, kHeight), options);
  const io::Image& map = mapOf(baked, "normal");
  for (Index row = 0; row < 64; ++row)  // waves do not depend on y
    for (Index column = 1; column < 63; ++column)
      for (std::size_t c = 0; c < 3; ++c) {
        const auto at = [&](Index r) {
          return int(map.texels[4 * (std::size_t{r} * 64 + column) + c]);
        };
        const int below = c == 1 ? 255 - at(63 - row) : at(63 - row);
        CHECK(std::abs(at(row) - below) <= 1);
      }
}

// A right-angled roof over x from -1 to 1, its ridge along y at this height, each side with its own
// vertices and flat normals; its colour is (x + 1) / 2, 0, 0.
TriangleMesh roof(double ridge) {
  TriangleMesh mesh;
  Attribute colors{"COLOR_0", 3, {}}, normals{"NORMAL", 3, {}};
  for (const double side : {-1.0, 1.0})
    for (const Vec2& at : {Vec2(0, 0), Vec2(side, 0), Vec2(side, 1), Vec2(0, 1)}) {
      const double x = at.x();
      mesh.positions.emplace_back(x, at.y(), ridge - std::abs(x));
      for (const double c : {(x + 1) / 2, 0.0, 0.0}) colors.values.push_back(float(c));
      for (const double c : {side * std::sqrt(0.5), 0.0, std::sqrt(0.5)})
        normals.values.push_back(float(c));
    }
  mesh.indices = {0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7};
  mesh.attributes = {std::move(colors), std::move(normals)};
  return mesh;
}

TEST_CASE("bake onto: both sides of a sharp edge show one place of a surface beside it") {
  TriangleMesh low = roof(0);
  low.attributes.clear();
  RemeshOptions options;
  options.cage = 20;
  const Baked baked = bakedOnto(std::move(low), roof(0.3), options);
  CHECK(baked.report.charts == 2);
  const io::Image& map = mapOf(baked, "baseColor");
  const TriangleMesh& mesh = baked.model.parts.front().mesh;
  const Attribute& texcoords = *findAttribute(mesh, "TEXCOORD_0");
  std::size_t count = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (mesh.positions[v].x() != 0) continue;
    const auto column = Index(double(texcoords.values[2 * v]) * map.width);
    const auto row = Index(double(texcoords.values[2 * v + 1]) * map.height);
    const int shown = map.texels[4 * (std::size_t{row} * map.width + column)];
    CHECK(std::abs(shown - 188) <= 4);  // half the light, and up to a texel beside it
    ++count;
  }
  CHECK(count == 4);
}
