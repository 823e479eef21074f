// SPDX-License-Identifier: MIT
#include "schemes/chart_keeper.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "schemes/remesh.h"

using namespace remesher;

namespace {

constexpr int kSide = 24;
// Charts lie this far apart in the texture, so that a value tells of its chart.
constexpr float kApart = 2 * kSide;

// A gently bent sheet of cells one wide. Where chartAt changes from one column of cells to the next
// a chart begins: its u counts from kApart × its number on, its v is y.
template <class ChartAt>
TriangleMesh sheetOf(ChartAt chartAt) {
  TriangleMesh mesh;
  Attribute uv{"TEXCOORD_0", 2, {}};
  Index begin = 0;
  for (Index x = 0; x < kSide; ++x) {
    if (x > 0 && chartAt(x) != chartAt(x - 1)) begin = x;
    const Index first = Index(mesh.positions.size());
    for (Index y = 0; y <= kSide; ++y)
      for (const Index dx : {0, 1}) {
        mesh.positions.emplace_back(x + dx, y, std::cos(0.1 * (x + dx)) + std::cos(0.1 * y));
        uv.values.push_back(kApart * float(chartAt(x)) + float(x + dx - begin));
        uv.values.push_back(float(y));
      }
    for (Index y = 0; y < kSide; ++y) {
      const Index a = first + 2 * y;
      mesh.indices.insert(mesh.indices.end(), {a, a + 1, a + 3, a, a + 3, a + 2});
    }
  }
  mesh.attributes.push_back(std::move(uv));
  return mesh;
}

TriangleMesh strips() {
  return sheetOf([](Index x) { return x; });
}

const std::vector<float>& texcoords(const TriangleMesh& mesh) {
  REQUIRE(findAttribute(mesh, "TEXCOORD_0"));
  return findAttribute(mesh, "TEXCOORD_0")->values;
}

}  // namespace

TEST_CASE("chart_keeper: no triangle spans two charts, whether their seams are kept or not") {
  const TriangleMesh input = strips();
  for (const std::size_t vertices : {60, 200, 1500}) {
    CAPTURE(vertices);
    RemeshOptions options;
    options.vertices = vertices;
    const TriangleMesh mesh = remeshSurface(input, options, {}).mesh;
    const std::vector<float>& uv = texcoords(mesh);
    const auto u = [&](std::size_t corner) { return uv[2 * std::size_t{mesh.indices[corner]}]; };
    for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
      const float chart = std::round(u(3 * t) / kApart);
      for (std::size_t k = 3 * t; k < 3 * t + 3; ++k) {
        // Within the chart, which is one wide, but for rounding.
        CHECK(u(k) - chart * kApart >= -1e-4F);
        CHECK(u(k) - chart * kApart <= 1 + 1e-4F);
      }
    }
  }
}

TEST_CASE("chart_keeper: a vertex takes the value at the nearest place of the triangle's chart") {
  RemeshOptions options;
  options.vertices = 60;  // edges three strips long: most seams are let go
  const TriangleMesh mesh = remeshSurface(strips(), options, {}).mesh;
  const std::vector<float>& uv = texcoords(mesh);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const double chart = std::round(uv[2 * v] / kApart);
    const double nearest = std::clamp(mesh.positions[v].x() - chart, 0.0, 1.0);
    // The sheet bends by 0.1 a unit: what fitting lifts off it shifts the nearest place a little.
    CHECK(std::abs(uv[2 * v] - kApart * chart - nearest) < 0.05);
    CHECK(std::abs(uv[2 * v + 1] - mesh.positions[v].y()) < 0.3);
  }
}

TEST_CASE("chart_keeper: a chart too narrow for triangles gives way all along") {
  const TriangleMesh input = sheetOf([](Index x) { return x < 12 ? 0U : x == 12 ? 1U : 2U; });
  RemeshOptions options;
  options.vertices = 100;  // edges 2.6 long beside a strip 1 wide
  const TriangleMesh mesh = remeshSurface(input, options, {}).mesh;
  const std::vector<float>& uv = texcoords(mesh);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    CHECK(std::abs(uv[2 * v] - kApart) > 2);  // the strip has those from 48 to 49
}
