// SPDX-License-Identifier: MIT
#include "painting/painter.h"

#include <doctest/doctest.h>

#include <cmath>
#include <memory>

#include "painting/squares.h"

using namespace remesher;

namespace {

// Black and white texels, as many as on a chess board.
io::Image chess(Index size) {
  io::Image image{size, size, {}};
  for (Index y = 0; y < size; ++y)
    for (Index x = 0; x < size; ++x)
      for (int c = 0; c < 4; ++c) image.texels.push_back(c == 3 || (x + y) % 2 ? 255 : 0);
  return image;
}

}  // namespace

using namespace remesher::test;

TEST_CASE("painter: averages light over the texel") {
  TriangleMesh mesh;
  addSquare(mesh, 0, Facing::Up);
  mesh.attributes.push_back({"TEXCOORD_0", 2, {0, 0, 1, 0, 1, 1, 0, 1}});
  io::Material material;
  material.baseColorMap.image = "0";
  const std::vector<io::NamedImage> images = {{"0", chess(128)}};
  std::vector<std::unique_ptr<PaintSource>> sources;
  sources.push_back(sourceOf(mesh, {material}, images));
  std::vector<CanvasTriangle> canvas(2);
  for (Index h = 0; h < 6; ++h) {
    const Vec3& p = mesh.positions[mesh.indices[h]];
    InputPlace place{h / 3, Vec3::Unit(h % 3)};
    canvas[h / 3].corners[h % 3] = {
        p, Vec3::UnitZ(), {1, 0, 0, -1}, Vec2(p.x(), p.y()) * 16, place};
    canvas[h / 3].source = 0;
  }
  const Painting painting = paint(canvas, sources, {16, true, 8}, Progress());
  for (std::size_t i = 0; i < painting.baseColor.texels.size(); i += 4) {
    CHECK(std::abs(painting.baseColor.texels[i] - 188) <= 2);
    CHECK(painting.baseColor.texels[i + 3] == 255);
    CHECK(painting.normal.texels[i] == 128);
    CHECK(painting.normal.texels[i + 2] == 255);
  }
}
