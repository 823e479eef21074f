// SPDX-License-Identifier: MIT
#include "remesh/transfer/chart_keeper.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/mesh_builder.h"
#include "original/curves/seams.h"
#include "remesh/schemes/remesh.h"

using namespace remesher;

namespace {

constexpr int kStrips = 24;
// Charts lie this far apart in the texture, so that a value tells of its chart.
constexpr float kApart = 2 * kStrips;

// A gently bent sheet of cells one wide. Where chartAt changes from one column of cells to the next
// a chart begins: its u counts from kApart × its number on, its v is y.
template <class ChartAt>
TriangleMesh sheetOf(ChartAt chartAt) {
  TriangleMesh mesh;
  Attribute uv{"TEXCOORD_0", 2, {}};
  Index begin = 0;
  for (Index x = 0; x < kStrips; ++x) {
    if (x > 0 && chartAt(x) != chartAt(x - 1)) begin = x;
    const Index first = Index(mesh.positions.size());
    for (Index y = 0; y <= kStrips; ++y)
      for (const Index dx : {0, 1}) {
        mesh.positions.emplace_back(x + dx, y, std::cos(0.1 * (x + dx)) + std::cos(0.1 * y));
        uv.values.push_back(kApart * float(chartAt(x)) + float(x + dx - begin));
        uv.values.push_back(float(y));
      }
    for (Index y = 0; y < kStrips; ++y) {
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

// A floor 8 wide, a step of 0.2 down and a floor 16 wide, each with normals of its own. The texture
// goes on from the first floor over the step and jumps at the second.
TriangleMesh step() {
  struct Column {
    double x, z;
    float u;
  };
  TriangleMesh mesh;
  Attribute uv{"TEXCOORD_0", 2, {}}, normals{"NORMAL", 3, {}};
  const auto add = [&](const std::vector<Column>& columns, const Eigen::Vector3f& normal) {
    for (std::size_t i = 0; i < columns.size(); ++i)
      for (Index y = 0; y <= kStrips; ++y) {
        const Index a = Index(mesh.positions.size()), b = a + kStrips + 1;
        mesh.positions.emplace_back(columns[i].x, y, columns[i].z);
        uv.values.insert(uv.values.end(), {columns[i].u, float(y)});
        normals.values.insert(normals.values.end(), normal.begin(), normal.end());
        if (i + 1 < columns.size() && y < kStrips)
          mesh.indices.insert(mesh.indices.end(), {a, b, b + 1, a, b + 1, a + 1});
      }
  };
  std::vector<Column> upper, lower;
  for (int x = 0; x <= 8; ++x) upper.push_back({double(x), 0.2, float(x)});
  for (int x = 8; x <= kStrips; ++x) lower.push_back({double(x), 0, kApart + float(x)});
  add(upper, {0, 0, 1});
  add({{8, 0.2, 8}, {8, 0, 8.2F}}, {1, 0, 0});
  add(lower, {0, 0, 1});
  mesh.attributes = {std::move(uv), std::move(normals)};
  return mesh;
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
    PartOptions options;
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
  PartOptions options;
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
  PartOptions options;
  options.vertices = 100;  // edges 2.6 long beside a strip 1 wide
  const TriangleMesh mesh = remeshSurface(input, options, {}).mesh;
  const std::vector<float>& uv = texcoords(mesh);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    CHECK(std::abs(uv[2 * v] - kApart) > 2);  // the strip has those from 48 to 49
}

TEST_CASE("chart_keeper: a triangle all within what is absorbed shows what is not") {
  const TriangleMesh input = sheetOf([](Index x) { return x < 10 ? 0U : x < 14 ? x - 9 : 5U; });
  BuiltMesh built = buildMesh(input);
  ChartRules rules{findSeams(built, input, 40).jumps, FaceData<char>(built.mesh.faceCapacity(), 0)};
  const auto middle = [&](Face f) {
    const auto [a, b, c] = built.mesh.vertices(f);
    return (built.positions[a].x() + built.positions[b].x() + built.positions[c].x()) / 3;
  };
  for (Index f = 0; f < built.mesh.faceCapacity(); ++f)
    rules.absorbed[Face(f)] = middle(Face(f)) > 10 && middle(Face(f)) < 14;
  FeatureCurves curves(built.mesh, built.positions, {});
  const OriginalSurface surface(std::move(built), std::move(curves));
  const WorkingMesh mesh(surface);
  ChartKeeper keeper(mesh, rules);
  for (Index f = 0; f < mesh.mesh().faceCapacity(); ++f) {
    CAPTURE(f);
    std::array<SurfacePoint, 3> points;
    for (int k = 0; k < 3; ++k) points[k] = mesh.cornerPoint(HalfedgeMesh::halfedge(Face(f), k));
    keeper.intoOneChart(points);
    for (const SurfacePoint& point : points) {
      CHECK_FALSE(rules.absorbed[point.face]);
      CHECK((surface.position(point).x() < 12) == (surface.position(points[0]).x() < 12));
    }
  }
}

TEST_CASE("chart_keeper: a step too low for triangles takes its neighbour's shading") {
  const TriangleMesh input = step();
  PartOptions options;
  options.vertices = 100;  // edges 2.6 long, and a step of 0.2: less than a tenth
  options.prefer = Prefer::Even;
  const TriangleMesh mesh = remeshSurface(input, options, {}).mesh;
  const Attribute* normals = findAttribute(mesh, "NORMAL");
  REQUIRE(normals);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    CAPTURE(v);
    CHECK(normals->values[3 * v + 2] > 0.9F);  // the step's own is (1, 0, 0)
  }
}

TEST_CASE("chart_keeper: both halves of a quad show one chart, and share its places") {
  const TriangleMesh input = sheetOf([](Index x) { return x / 3; });
  PartOptions options;
  options.vertices = 90;
  options.quads = true;
  const TriangleMesh mesh = remeshSurface(input, options, {}).mesh;
  REQUIRE(mesh.isQuads);
  CHECK(arePairs(mesh));
}
