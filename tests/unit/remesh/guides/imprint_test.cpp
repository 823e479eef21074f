// SPDX-License-Identifier: MIT
#include "remesh/guides/imprint.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "base/place.h"
#include "geometry/extent.h"
#include "mesh/mesh_builder.h"
#include "support/shapes.h"

using namespace remesher;

namespace {

// A circle about the z axis on the unit sphere.
Guide levelCircle(double z, int count) {
  Guide guide{{}, GuideKind::Loop, true, "circle"};
  for (int k = 0; k < count; ++k) {
    const Vec3 p = shapes::onCircle(k, count);
    guide.points.push_back(std::sqrt(1 - z * z) * p + Vec3(0, 0, z));
  }
  return guide;
}

double awayFrom(const TriangleMesh& input, const Vec3& p) {
  const TriangleTree tree(input.positions, input.indices);
  return std::sqrt(tree.nearest(p).squaredDistance);
}

}  // namespace

TEST_CASE("imprint: a line becomes edges, and the surface stays what it is") {
  const TriangleMesh sphere = shapes::icosphere(6);
  Imprint imprint(sphere, {}, 0.01);
  const Guide made = imprint.add(levelCircle(0.3, 40));
  REQUIRE(made.points.size() >= 40);
  const TriangleMesh& mesh = imprint.mesh();
  const BuiltMesh built = buildMesh(mesh);
  CHECK(2 * built.mesh.vertexCount() == built.mesh.faceCount() + 4);  // a closed sphere
  CHECK(built.warnings.empty());
  CHECK(extentOf(mesh).area == doctest::Approx(extentOf(sphere).area));
  for (const Vec3& p : mesh.positions) CHECK(awayFrom(sphere, p) < 1e-12);
  for (const Vec3& p : made.points) CHECK(std::abs(p.z() - 0.3) < 0.03);
  const std::vector<Index> first = weld(mesh.positions);
  std::set<std::pair<Index, Index>> known;
  for (std::size_t i = 0; i < mesh.indices.size(); ++i)
    known.insert(std::minmax(first[mesh.indices[i]], first[mesh.indices[i / 3 * 3 + (i + 1) % 3]]));
  for (const auto& edge : imprint.edges()) CHECK(known.contains(edge));
  CHECK(imprint.edges().size() == made.points.size());
}

TEST_CASE("imprint: places on the divided mesh are where they are on the input") {
  const TriangleMesh sphere = shapes::icosphere(4);
  Imprint imprint(sphere, {}, 0.01);
  imprint.add(levelCircle(0.1, 30));
  imprint.add(levelCircle(-0.4, 30));
  const TriangleMesh& mesh = imprint.mesh();
  const auto at = [](const TriangleMesh& of, const InputPlace& place) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 0; k < 3; ++k)
      sum += place.weights[Eigen::Index(k)] * of.positions[of.indices[cornerOf(place.triangle, k)]];
    return sum;
  };
  for (Index t = 0; t < mesh.triangleCount(); ++t) {
    const InputPlace place{InputTriangle{t}, {0.2, 0.3, 0.5}};
    CHECK((at(mesh, place) - at(sphere, imprint.onInput(place))).norm() < 1e-12);
  }
  for (auto v = Index(sphere.positions.size()); v < mesh.positions.size(); ++v)
    CHECK((at(sphere, imprint.placeOf(v)) - mesh.positions[v]).norm() < 1e-12);
}

TEST_CASE("imprint: edges of the caller are divided with the triangles") {
  TriangleMesh sheet;
  shapes::addSheet(sheet, 2, 2, [](int x, int y) { return Vec3(x, y, 0); });
  const std::vector<std::pair<Index, Index>> middle = {{3, 4}, {4, 5}};
  Imprint imprint(sheet, middle, 1e-6);
  const Guide made = imprint.add({{{0.4, 0.3, 0}, {0.4, 1.7, 0}}, GuideKind::Loop, false, "line"});
  REQUIRE(!made.points.empty());
  double length = 0;
  for (const auto& [a, b] : imprint.edges()) {
    const Vec3 side = imprint.mesh().positions[b] - imprint.mesh().positions[a];
    length += side.norm();
    CHECK((std::abs(side.x()) < 1e-9 || std::abs(side.y()) < 1e-9));
  }
  CHECK(length == doctest::Approx(2 + 1.4));
}

TEST_CASE("imprint: along a seam the vertices of both sides are divided") {
  TriangleMesh sheet;
  shapes::addSheet(sheet, 1, 2, [](int x, int y) { return Vec3(x, y, 0); });
  const auto first = Index(sheet.positions.size());
  shapes::addSheet(sheet, 1, 2, [](int x, int y) { return Vec3(x + 1, y, 0); });
  Imprint imprint(sheet, {}, 1e-6);
  imprint.add({{{0.3, 0.6, 0}, {1.7, 0.6, 0}}, GuideKind::Loop, false, "across"});
  int copies = 0;
  for (auto v = Index(sheet.positions.size()); v < imprint.mesh().positions.size(); ++v)
    copies += std::abs(imprint.mesh().positions[v].x() - 1) < 1e-12;
  CHECK(copies == 2);
  for (std::size_t i = 0; i < imprint.mesh().indices.size(); ++i) {
    const Index v = imprint.mesh().indices[i];
    if (v < sheet.positions.size()) continue;
    CHECK((imprint.placeOf(v).triangle.index >= 4) ==
          (imprint.onInput({InputTriangle{Index(i / 3)}, Vec3::UnitX()}).triangle.index >= 4));
  }
  CHECK(first == 6);
}
