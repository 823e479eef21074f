// SPDX-License-Identifier: MIT
#include "repair/sheet_bodies.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "geometry/triangle.h"
#include "measure/mesh_report.h"
#include "measure/self_intersections.h"
#include "repair/repair.h"
#include "support/hostile_shapes.h"
#include "support/shapes.h"
#include "support/soups.h"
#include "support/volume_of.h"

using namespace remesher;
using shapes::volumeOf;

namespace {

void checkSound(const TriangleMesh& mesh) {
  const MeshReport report = inspectMesh(mesh);
  CHECK(report.boundaryEdges == 0);
  CHECK(report.nonManifoldEdges == 0);
  CHECK(report.degenerateTriangles == 0);
  CHECK(selfIntersections(mesh).empty());
}

TriangleMesh relief() {
  TriangleMesh mesh;
  shapes::addSheet(mesh, 12, 9, [](int x, int y) {
    return Vec3(x, y, std::sin(0.7 * x) + 0.5 * std::cos(1.1 * y));
  });
  return mesh;
}

RepairedMesh madeBodies(const TriangleMesh& mesh, std::optional<double> thickness, bool hasBase) {
  PartOptions options;
  options.repair = Repair::Auto;
  options.edgeLength = 1;
  options.thickness = thickness;
  options.base = hasBase;
  return repairSurface(mesh, options);
}

}  // namespace

TEST_CASE("sheet bodies: a flat sheet becomes a plate of exactly that thickness") {
  const TriangleMesh sheet = shapes::grid(5, 3);
  const TriangleMesh plate = bodiesOfSheets(sheet, {BodyRule::Kind::Thick, 0.5}).mesh;
  CHECK(volumeOf(plate) == doctest::Approx(5 * 3 * 0.5));
  for (std::size_t i = 0; i < plate.indices.size(); ++i)
    CHECK(std::abs(plate.positions[plate.indices[i]].z()) == 0.25);
  CHECK(plate.triangleCount() == 2 * sheet.triangleCount() + 2 * 16);
}

TEST_CASE("sheet bodies: walls of a bent sheet are as thick as its flat parts") {
  TriangleMesh angle;  // two plates at a right angle
  shapes::addSheet(angle, 4, 3,
                   [](int x, int y) { return x <= 2 ? Vec3(2 - x, y, 0) : Vec3(0, y, x - 2); });
  const RepairedMesh result = madeBodies(angle, 0.2, false);
  checkSound(result.mesh);
  CHECK(result.report.bodies == 1);
  // Both arms with the corner mitred, whichever way it turns: 2 × 2 × 3 × 0.2.
  CHECK(volumeOf(result.mesh) == doctest::Approx(2.4).epsilon(1e-9));
}

TEST_CASE("sheet bodies: folds tighter than the thickness are cut clean") {
  TriangleMesh wave;
  shapes::addSheet(wave, 40, 6, [](int x, int y) {
    return Vec3(0.2 * x, 0.4 * y, 0.8 * std::sin(0.2 * x * 4));
  });
  const RepairedMesh result = madeBodies(wave, 0.5, false);
  checkSound(result.mesh);
  CHECK(result.report.reason == "made");
  CHECK(volumeOf(result.mesh) > 0);
}

TEST_CASE("sheet bodies: a relief gets upright walls and a flat base, and stays as it is") {
  const TriangleMesh sheet = relief();
  for (const bool isTurned : {false, true}) {
    const RepairedMesh result = madeBodies(isTurned ? shapes::turnedOver(sheet) : sheet, 2.0, true);
    checkSound(result.mesh);
    double low = kInfinity, high = -kInfinity, lowest = kInfinity, highest = -kInfinity;
    for (const Vec3& p : sheet.positions) low = std::min(low, p.z()), high = std::max(high, p.z());
    for (const Vec3& p : result.mesh.positions)
      lowest = std::min(lowest, p.z()), highest = std::max(highest, p.z());
    CHECK((isTurned ? highest - high : low - lowest) == doctest::Approx(2));
    for (const Vec3& p : result.mesh.positions)
      CHECK(
          (p.z() == lowest || p.z() == highest ||
           std::find(sheet.positions.begin(), sheet.positions.end(), p) != sheet.positions.end()));
  }
}

TEST_CASE("sheet bodies: attributes come along") {
  TriangleMesh sheet = shapes::grid(3, 2);
  sheet.attributes = {{"TEXCOORD_0", 2, {}}, {"NORMAL", 3, {}}};
  for (const Vec3& p : sheet.positions) {
    sheet.attributes[0].values.insert(sheet.attributes[0].values.end(),
                                      {float(p.x()), float(p.y())});
    sheet.attributes[1].values.insert(sheet.attributes[1].values.end(), {0.F, 0.F, 1.F});
  }
  const TriangleMesh plate = madeBodies(sheet, 0.5, false).mesh;
  for (const Index v : plate.indices) {
    const float* uv = &plate.attributes[0].values[2 * std::size_t{v}];
    CHECK(uv[0] == float(plate.positions[v].x()));
    CHECK(uv[1] == float(plate.positions[v].y()));
  }
  for (std::size_t i = 0; i < plate.indices.size(); i += 3) {
    const auto at = [&](std::size_t k) { return plate.positions[plate.indices[i + k]]; };
    const Vec3 normal = (at(1) - at(0)).cross(at(2) - at(0)).normalized();
    for (std::size_t k = 0; k < 3; ++k) {
      const float* own = &plate.attributes[1].values[3 * std::size_t{plate.indices[i + k]}];
      CHECK(normal.dot(Vec3(own[0], own[1], own[2])) == doctest::Approx(1));
    }
  }
}

TEST_CASE("sheet bodies: a bowl becomes one, and a small hole in it is closed") {
  TriangleMesh bowl;
  shapes::addSheet(bowl, 32, 8, [](int k, int row) {
    const double angle = 1.5 * (row + 1) / 9.0;
    return Vec3(std::sin(angle) * shapes::onCircle(k, 32) + Vec3(0, 0, -std::cos(angle)));
  });
  for (int k = 0; k < 31; ++k)  // the bottom, without the last triangle
    shapes::addTriangle(bowl, shapes::addVertex(bowl, {0, 0, -1}), Index(k + 1), Index(k));
  const RepairedMesh result = madeBodies(bowl, 0.05, false);
  checkSound(result.mesh);
  CHECK(result.report.bodies == 1);
  CHECK(inspectMesh(result.mesh).eulerCharacteristic == 2);
}

TEST_CASE("sheet bodies: a Möbius strip becomes one ring, whichever triangles are turned over") {
  TriangleMesh strip = shapes::moebiusStrip(48);
  double area = 0;
  for (std::size_t i = 0; i < strip.indices.size(); i += 3)
    area += remesher::area(strip.positions[strip.indices[i]], strip.positions[strip.indices[i + 1]],
                           strip.positions[strip.indices[i + 2]]);
  for (const bool isMixed : {false, true}) {
    if (isMixed) std::swap(strip.indices[31], strip.indices[32]);
    const RepairedMesh result = madeBodies(strip, 0.02, false);
    checkSound(result.mesh);
    const MeshReport report = inspectMesh(result.mesh);
    CHECK(report.eulerCharacteristic == 0);
    CHECK(report.components == 1);
    CHECK(result.report.bodies == 1);
    CHECK(result.report.lost == 0);
    CHECK(volumeOf(result.mesh) == doctest::Approx(0.02 * area).epsilon(0.01));
    for (const PlacedWarning& said : result.warnings)
      CHECK(said.warning.code == "SHEETS_MADE_BODIES");
  }
}

TEST_CASE("sheet bodies: no base is put under a surface of one side") {
  const TriangleMesh strip = shapes::moebiusStrip(24);
  CHECK(madeBodies(strip, std::nullopt, true).mesh.indices == strip.indices);
}

TEST_CASE("sheet bodies: what is closed stays as it is") {
  const TriangleMesh ball = soups::moved(shapes::icosphere(3), {9, 0, 0});
  const RepairedMesh result = madeBodies(soups::joined({ball, shapes::grid(3, 2)}), 0.5, false);
  checkSound(result.mesh);
  for (const Index v : ball.indices)
    CHECK(std::find(result.mesh.positions.begin(), result.mesh.positions.end(),
                    ball.positions[v]) != result.mesh.positions.end());
}
