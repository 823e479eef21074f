// SPDX-License-Identifier: MIT
#include "jobs/parts/drawing_order.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "support/shapes.h"

using namespace remesher;

namespace {

// Sheets of so many cells along a side, one above the other, the lowest first.
TriangleMesh layers(int cells) {
  TriangleMesh mesh;
  for (const double height : {0.0, 0.3, 0.6})
    shapes::addSheet(mesh, cells, cells, [&](int column, int row) {
      return Vec3(double(column) / cells, double(row) / cells, height);
    });
  return mesh;
}

// Whether no face of the mesh is above one that comes later.
bool isFromBelow(const TriangleMesh& mesh) {
  return std::is_sorted(mesh.indices.begin(), mesh.indices.end(), [&](Index a, Index b) {
    return mesh.positions[a].z() < mesh.positions[b].z();
  });
}

io::Part drawnPart(TriangleMesh mesh, bool isOpaque) {
  io::Part part{"", std::move(mesh), {}};
  part.groups.resize(1);
  part.groups.front().look.isOpaque = isOpaque;
  return part;
}

}  // namespace

TEST_CASE("faces of what is seen through are drawn in the original's order") {
  for (const bool isQuads : {false, true}) {
    TriangleMesh reversed = layers(4);
    for (std::size_t i = 0; i < reversed.indices.size() / 2; i += 6)
      std::swap_ranges(reversed.indices.begin() + std::ptrdiff_t(i),
                       reversed.indices.begin() + std::ptrdiff_t(i + 6),
                       reversed.indices.end() - std::ptrdiff_t(i + 6));
    reversed.isQuads = isQuads;
    REQUIRE_FALSE(isFromBelow(reversed));
    for (const bool isOpaque : {true, false}) {
      std::vector<io::Part> made = {drawnPart(reversed, isOpaque)};
      keepDrawingOrder(made, {drawnPart(layers(7), isOpaque)});
      CHECK(isFromBelow(made.front().mesh) == !isOpaque);
      if (isQuads) CHECK(arePairs(made.front().mesh));
    }
  }
}
