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
constexpr float kApart = 10;

// A gently bent sheet of strips one cell wide, each a chart of its own.
TriangleMesh strips() {
  TriangleMesh mesh;
  Attribute uv{"TEXCOORD_0", 2, {}};
  for (Index x = 0; x < kSide; ++x) {
    const Index first = Index(mesh.positions.size());
    for (Index y = 0; y <= kSide; ++y)
      for (const Index dx : {0, 1}) {
        mesh.positions.emplace_back(x + dx, y, std::cos(0.1 * (x + dx)) + std::cos(0.1 * y));
        uv.values.push_back(kApart * float(x) + float(dx));
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

}  // namespace

TEST_CASE("chart_keeper: no triangle spans two charts, whether their seams are kept or not") {
  const TriangleMesh input = strips();
  for (const std::size_t vertices : {60, 200, 1500}) {
    CAPTURE(vertices);
    RemeshOptions options;
    options.vertices = vertices;
    const TriangleMesh mesh = remeshSurface(input, options, {}).mesh;
    REQUIRE(findAttribute(mesh, "TEXCOORD_0"));
    const std::vector<float>& uv = findAttribute(mesh, "TEXCOORD_0")->values;
    const auto u = [&](std::size_t corner) { return uv[2 * std::size_t{mesh.indices[corner]}]; };
    for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
      const float chart = std::floor(u(3 * t) / kApart);
      for (std::size_t k = 3 * t; k < 3 * t + 3; ++k) {
        // Within the chart, which is one wide, but for rounding.
        CHECK(u(k) - chart * kApart >= -1e-4F);
        CHECK(u(k) - chart * kApart <= 1 + 1e-4F);
      }
    }
  }
}

TEST_CASE("chart_keeper: a vertex takes the value at the nearest place of the triangle's chart") {
  const TriangleMesh input = strips();
  RemeshOptions options;
  options.vertices = 200;
  const TriangleMesh mesh = remeshSurface(input, options, {}).mesh;
  const std::vector<float>& uv = findAttribute(mesh, "TEXCOORD_0")->values;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const double chart = std::floor(uv[2 * v] / kApart);
    const double nearest = std::clamp(mesh.positions[v].x() - chart, 0.0, 1.0);
    // The sheet bends by 0.1 a unit: what fitting lifts off it shifts the nearest place a little.
    CHECK(uv[2 * v] - kApart * chart == doctest::Approx(nearest).epsilon(0.05));
  }
}
