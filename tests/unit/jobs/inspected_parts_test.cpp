// SPDX-License-Identifier: MIT
#include "jobs/inspected_parts.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "remesher.h"
#include "support/shapes.h"

using namespace remesher;

namespace {

using PlacedTriangle = std::array<std::array<double, 3>, 3>;

// The triangles by their corners in whole thousandths, in an order of their own.
std::vector<PlacedTriangle> placedTriangles(const TriangleMesh& mesh, const Vec3& by,
                                            double factor) {
  std::vector<PlacedTriangle> all;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    PlacedTriangle corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 p = (mesh.positions[mesh.indices[i + k]] / factor - by) * 1e5;
      corners[k] = {std::round(p.x()) + 0.0, std::round(p.y()) + 0.0, std::round(p.z()) + 0.0};
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    all.push_back(corners);
  }
  std::sort(all.begin(), all.end());
  return all;
}

// A torus of 288 vertices in whole hundredths, which has no symmetry that could hide an order.
TriangleMesh bentTorus(const Vec3& by, double factor) {
  TriangleMesh mesh = shapes::torus(24, 12);
  for (Vec3& p : mesh.positions) {
    p.z() += 0.1 * p.x() * p.x() + 0.05 * p.y();
    p = ((p + by) * 100).array().round() * factor / 100;
  }
  return mesh;
}

TriangleMesh backwards(TriangleMesh mesh) {
  std::reverse(mesh.positions.begin(), mesh.positions.end());
  for (Index& v : mesh.indices) v = Index(mesh.positions.size()) - 1 - v;
  for (std::size_t i = 0; i < mesh.indices.size() / 2; i += 3)
    std::swap_ranges(mesh.indices.begin() + std::ptrdiff_t(i),
                     mesh.indices.begin() + std::ptrdiff_t(i) + 3,
                     mesh.indices.end() - std::ptrdiff_t(i) - 3);
  for (std::size_t i = 0; i < mesh.indices.size(); i += 6)
    std::rotate(&mesh.indices[i], &mesh.indices[i + 1], &mesh.indices[i] + 3);
  return mesh;
}

PartOptions to150() {
  PartOptions options;
  options.vertices = 150;
  return options;
}

}  // namespace

TEST_CASE("inspected_parts: a vertex that noise moves off its twin at zero stays its twin") {
  TriangleMesh sheet;
  sheet.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0},       {0, 1, 0},
                     {2, 0, 0}, {2, 1, 0}, {1, -2.4e-16, 0}};
  sheet.indices = {0, 1, 2, 0, 2, 3, 6, 4, 5, 6, 5, 2};
  const MeshReport report = inspectScaled({{"", sheet, {}}});
  CHECK(report.vertices == 6);
  CHECK(report.components == 1);
}

TEST_CASE("inspected_parts: place and unit of decimals do not change the result") {
  const std::vector<PlacedTriangle> one =
      placedTriangles(remesh(bentTorus(Vec3::Zero(), 1), to150()).mesh, Vec3::Zero(), 1);
  for (const Vec3& by : {Vec3(0.25, 7.5, -3.75), Vec3(500000, 5.4e6, 295)}) {
    CAPTURE(by.x());
    CHECK(placedTriangles(remesh(bentTorus(by, 1), to150()).mesh, by, 1) == one);
  }
  for (const double factor : {1000.0, 1024.0}) {
    CAPTURE(factor);
    CHECK(placedTriangles(remesh(bentTorus(Vec3::Zero(), factor), to150()).mesh, Vec3::Zero(),
                          factor) == one);
  }
}

TEST_CASE("inspected_parts: the order of vertices and triangles does not change the result") {
  const TriangleMesh mesh = bentTorus(Vec3::Zero(), 1);
  for (const bool quads : {false, true}) {
    PartOptions options = to150();
    options.quads = quads;
    const std::vector<PlacedTriangle> one =
        placedTriangles(remesh(mesh, options).mesh, Vec3::Zero(), 1);
    CHECK(placedTriangles(remesh(backwards(mesh), options).mesh, Vec3::Zero(), 1) == one);
  }
}

TEST_CASE("inspected_parts: density and feature edges follow their vertices") {
  const TriangleMesh mesh = bentTorus(Vec3::Zero(), 1);
  const Index last = Index(mesh.positions.size()) - 1;
  PartOptions options = to150();
  options.featureEdges = {{mesh.indices[0], mesh.indices[1]}};
  for (const Vec3& p : mesh.positions) options.density.push_back(p.x() > 0 ? 4.0F : 1.0F);
  const std::vector<PlacedTriangle> one =
      placedTriangles(remesh(mesh, options).mesh, Vec3::Zero(), 1);
  PartOptions turned = options;
  std::reverse(turned.density.begin(), turned.density.end());
  for (auto& [a, b] : turned.featureEdges) a = last - a, b = last - b;
  CHECK(placedTriangles(remesh(backwards(mesh), turned).mesh, Vec3::Zero(), 1) == one);
  options.featureEdges = {{0, 295}};
  CHECK_THROWS_WITH_AS(remesh(mesh, options),
                       doctest::Contains("no edge between vertices 0 and 295"), Error);
}

TEST_CASE("inspected_parts: places on the parts lead back to the given triangles") {
  const TriangleMesh mesh = backwards(bentTorus(Vec3(3, 4, 5), 1));
  const std::vector<io::Part> parts = {{"", mesh, {}}};
  const InspectedParts inspected(parts);
  const TriangleMesh& own = inspected.parts()[0].mesh;
  const Vec3 weights(0.5, 0.3, 0.2);
  for (Index t = 0; t < own.triangleCount(); ++t) {
    const auto at = [](const TriangleMesh& in, const InputPlace& place) {
      Vec3 p = Vec3::Zero();
      for (std::size_t k = 0; k < 3; ++k)
        p += place.weights[Eigen::Index(k)] * in.positions[in.indices[cornerOf(place.triangle, k)]];
      return p;
    };
    const InputPlace place = {InputTriangle(t), weights};
    const InputPlace given = inspected.given(0, {place}).front();
    CHECK((inspected.given(0, at(own, place)) - at(mesh, given)).norm() < 1e-12);
  }
}
