// SPDX-License-Identifier: MIT
#include "textures/painting/painter.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "textures/painting/squares.h"

using namespace remesher;

namespace {

// Black and white fields, as many of each as on a chess board.
io::Image chess(Index size, Index field = 1) {
  io::Image image{size, size, {}};
  for (Index y = 0; y < size; ++y)
    for (Index x = 0; x < size; ++x)
      for (int c = 0; c < 4; ++c)
        image.texels.push_back(c == 3 || (x / field + y / field) % 2 ? 255 : 0);
  return image;
}

}  // namespace

using namespace remesher::test;

namespace {

// A square with its map, painted in 16 texels a side from 128.
struct MappedSquare {
  TriangleMesh mesh;
  std::vector<io::NamedImage> images;
  std::vector<std::unique_ptr<PaintSource>> sources;
  std::vector<CanvasTriangle> canvas{2};

  explicit MappedSquare(io::Image image) : images({{"0", std::move(image)}}) {
    addSquare(mesh, 0, Facing::Up);
    mesh.attributes.push_back({"TEXCOORD_0", 2, {0, 0, 1, 0, 1, 1, 0, 1}});
    io::Material material;
    material.baseColorMap.image = "0";
    sources.push_back(sourceOf(mesh, {material}, images));
    for (Index h = 0; h < 6; ++h) {
      const Vec3& p = mesh.positions[mesh.indices[h]];
      InputPlace place{InputTriangle(h / 3), Vec3::Unit(h % 3)};
      canvas[h / 3].corners[h % 3] = {
          p, Vec3::UnitZ(), Vec3::UnitZ(), {1, 0, 0, -1}, Vec2(p.x(), p.y()) * 16, place};
      canvas[h / 3].source = 0;
      canvas[h / 3].rims[h % 3] = h != 2 && h != 3;  // the diagonal
    }
  }

  Painting painted(bool isOpaque) const {
    return paint(canvas, sources, {16, isOpaque, 8}, Progress());
  }
};

}  // namespace

TEST_CASE("painter: averages light over the texel") {
  const Painting painting = MappedSquare(chess(128)).painted(true);
  for (std::size_t i = 0; i < painting.baseColor.texels.size(); i += 4) {
    CHECK(std::abs(painting.baseColor.texels[i] - 188) <= 2);
    CHECK(painting.baseColor.texels[i + 3] == 255);
    CHECK(painting.normal.texels[i] == 128);
    CHECK(painting.normal.texels[i + 2] == 255);
  }
}

TEST_CASE("painter: what cannot be seen has no colour") {
  io::Image image = chess(128, 4);  // and black is transparent
  for (std::size_t i = 0; i < image.texels.size(); i += 4) image.texels[i + 3] = image.texels[i];
  // Between fields one look mixes both, as whoever draws the original does: it is not all white.
  const Painting painting = MappedSquare(std::move(image)).painted(false);
  for (std::size_t i = 0; i < painting.baseColor.texels.size(); i += 4) {
    CHECK(painting.baseColor.texels[i] > 200);
    CHECK(std::abs(painting.baseColor.texels[i + 3] - 128) <= 6);
  }
}

TEST_CASE("painter: a texel shows the point that it is at, and beyond a rim what the rim shows") {
  // Black, white just before x = 1, red beyond; the chart is what lies before x = 1.
  TriangleMesh mesh;
  Attribute colors{"COLOR_0", 3, {}};
  const std::array<double, 4> ends = {0, 0.94, 1, 2};
  const std::array<Vec3, 3> paints = {Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(1, 0, 0)};
  for (std::size_t i = 0; i < 3; ++i) {
    addSquare(mesh, 0, Facing::Up);
    for (std::size_t v = 4 * i; v < 4 * i + 4; ++v) {
      mesh.positions[v].x() = ends[i + (mesh.positions[v].x() > 0.5)];
      for (const double x : paints[i]) colors.values.push_back(float(x));
    }
  }
  mesh.attributes.push_back(colors);
  std::vector<std::unique_ptr<PaintSource>> sources;
  sources.push_back(sourceOf(mesh));
  const std::array<Vec3, 4> corners = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)};
  const auto rowOf = [&](char rim) {
    std::vector<CanvasTriangle> canvas(2);
    for (Index h = 0; h < 6; ++h) {
      const Vec3& p = corners[std::array<Index, 6>{0, 1, 2, 0, 2, 3}[h]];
      canvas[h / 3].corners[h % 3] = {p,
                                      Vec3::UnitZ(),
                                      Vec3::UnitZ(),
                                      {1, 0, 0, -1},
                                      Vec2(3.5 + 10 * p.x(), 3 + 10 * p.y()),
                                      {InputTriangle(h / 3), Vec3::Unit(h % 3)}};
      canvas[h / 3].source = 0;
      canvas[h / 3].rims = {0, char(h / 3 == 0 ? rim : 0), 0};
    }
    const io::Image painted = paint(canvas, sources, {16, true, 2}, Progress()).baseColor;
    std::array<Vec3, 3> row;  // the texels from 12 on: the chart ends at 13.5
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t c = 0; c < 3; ++c)
        row[i][Eigen::Index(c)] = painted.texels[4 * (16 * 8 + 12 + i) + c];
    return row;
  };
  const Vec3 black(0, 0, 0), white(255, 255, 255), red(255, 0, 0), whiteAndRed(255, 188, 188);
  CHECK(rowOf(0) == std::array<Vec3, 3>{black, whiteAndRed, red});
  CHECK(rowOf(1) == std::array<Vec3, 3>{black, white, white});
}

TEST_CASE("painter: triangles count by how much of the texel lies on them") {
  // The texel's left half is black, of two triangles; its right half white, of one.
  TriangleMesh mesh;
  Attribute colors{"COLOR_0", 3, {}};
  const std::array<double, 3> ends = {0, 0.5, 2.5};
  for (std::size_t i = 0; i < 2; ++i) {
    addSquare(mesh, 0, Facing::Up);
    for (std::size_t v = 4 * i; v < 4 * i + 4; ++v) {
      mesh.positions[v].x() = ends[i + (mesh.positions[v].x() > 0.5)];
      for (int c = 0; c < 3; ++c) colors.values.push_back(float(i));
    }
  }
  mesh.attributes.push_back(colors);
  std::vector<std::unique_ptr<PaintSource>> sources;
  sources.push_back(sourceOf(mesh));
  CanvasTriangle all{};
  const std::array<Vec2, 3> corners = {Vec2(0, 0), Vec2(2, 0), Vec2(0, 2)};
  for (std::size_t k = 0; k < 3; ++k)
    all.corners[k] = {Vec3(corners[k].x(), corners[k].y(), 0),
                      Vec3::UnitZ(),
                      Vec3::UnitZ(),
                      {1, 0, 0, -1},
                      corners[k],
                      {InputTriangle(0), Vec3::Unit(Eigen::Index(k))}};
  const auto painted = paint({&all, 1}, sources, {1, true, 1}, Progress());
  CHECK(painted.baseColor.texels[0] == srgbOf(0.5));
}

TEST_CASE("painter: looks along the shape's normal and writes for that which light takes") {
  TriangleMesh mesh;
  addSquare(mesh, 0, Facing::Up);
  std::vector<std::unique_ptr<PaintSource>> sources;
  sources.push_back(sourceOf(mesh));
  CanvasTriangle half{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& p = mesh.positions[mesh.indices[k]];
    half.corners[k] = {p,
                       Vec3::UnitZ(),
                       Vec3(0, 0.6, 0.8),
                       {1, 0, 0, -1},
                       Vec2(4 * p.x(), 4 * p.y()),
                       {InputTriangle(0), Vec3::Unit(Eigen::Index(k))}};
  }
  const auto painted = paint({&half, 1}, sources, {4, true, 1}, Progress());
  // Up is 0.8 of that normal and 0.6 of the bitangent, (0, -0.8, 0.6).
  CHECK(painted.normal.texels[0] == 128);
  CHECK(painted.normal.texels[1] == byteOf(0.5 + 0.5 * 0.6));
  CHECK(painted.normal.texels[2] == byteOf(0.5 + 0.5 * 0.8));
}
