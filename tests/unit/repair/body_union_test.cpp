// SPDX-License-Identifier: MIT
#include "repair/body_union.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "measure/mesh_report.h"
#include "measure/self_intersections.h"
#include "repair/repair.h"
#include "repair/stitch.h"
#include "repair/united.h"
#include "support/hostile_shapes.h"
#include "support/shapes.h"
#include "support/soups.h"

using namespace remesher;

namespace {

RepairedMesh repairedByAuto(const TriangleMesh& mesh) {
  PartOptions options;
  options.repair = Repair::Auto;
  options.edgeLength = 1;  // so that the lattice is the coarsest that there is
  return repairSurface(mesh, options);
}

using CornerKey = std::tuple<double, double, double>;
CornerKey keyAt(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

std::set<std::array<CornerKey, 3>> trianglesAt(const TriangleMesh& mesh) {
  std::set<std::array<CornerKey, 3>> all;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    std::array<CornerKey, 3> t;
    for (std::size_t k = 0; k < 3; ++k) t[k] = keyAt(mesh.positions[mesh.indices[i + k]]);
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    all.insert(t);
  }
  return all;
}

bool holds(const TriangleMesh& mesh, const TriangleMesh& part) {
  const auto all = trianglesAt(mesh), own = trianglesAt(part);
  return std::includes(all.begin(), all.end(), own.begin(), own.end());
}

bool isSaid(const RepairedMesh& result, const char* code) {
  return std::any_of(result.warnings.begin(), result.warnings.end(),
                     [&](const PlacedWarning& one) { return one.warning.code == code; });
}

TriangleMesh inSinglePrecision(TriangleMesh mesh) {
  mesh.isSingle = true;
  for (Vec3& p : mesh.positions) p = p.cast<float>().cast<double>();
  return mesh;
}

// Boxes on each other, turned, so that their common planes are apart by roundings.
TriangleMesh turnedPlates(soups::Random& random) {
  TriangleMesh plates;
  for (int i = 0; i < 8; ++i) {
    const Vec3 at = (6 * random.point()).array().round() / 4, size(1.5, 1, 0.5 + 0.25 * (i % 3));
    TriangleMesh box = soups::cube(0, 1);
    for (Vec3& p : box.positions)
      p = Vec3(at.x(), at.y(), i % 2 == 0 ? 0 : 0.5) + p.cwiseProduct(size);
    plates = soups::joined({plates, box});
  }
  const double angle = 3 * random.number();
  const Vec3 axis = (random.point() - Vec3::Constant(0.5)).normalized();
  for (Vec3& p : plates.positions) p = Eigen::AngleAxisd(angle, axis) * p;
  return plates;
}

TriangleMesh enlarged(TriangleMesh mesh, double by) {
  for (Vec3& p : mesh.positions) p *= by;
  return mesh;
}

}  // namespace

TEST_CASE("body_union: a lattice remakes only what has no exact outside") {
  const TriangleMesh ball = shapes::icosphere(3);
  const TriangleMesh soup = soups::moved(enlarged(soups::randomSoup(40, 0.5, 3), 4), {9, 0, 0});
  const RepairedMesh result = repairedByAuto(soups::joined({soup, ball}));
  CHECK(result.isRemade);
  CHECK(result.report.reason == "partly");
  CHECK(holds(result.mesh, ball));
  CHECK(inspectMesh(result.mesh).boundaryEdges == 0);
  CHECK(selfIntersections(result.mesh).empty());
  CHECK(isSaid(result, "REMADE_IN_PART"));
}

TEST_CASE("body_union: what a lattice makes is united with bodies that it meets") {
  const TriangleMesh ball = shapes::icosphere(3);
  const TriangleMesh soup = soups::moved(enlarged(soups::randomSoup(40, 0.5, 3), 4), {0.5, 0, 0});
  const RepairedMesh result = repairedByAuto(soups::joined({soup, ball}));
  CHECK(result.isRemade);
  CHECK(inspectMesh(result.mesh).boundaryEdges == 0);
  CHECK(selfIntersections(result.mesh).empty());
}

TEST_CASE("body_union: bodies and sheets both stay where each is what it is") {
  const TriangleMesh ball = shapes::icosphere(3);
  TriangleMesh cards;
  for (int i = 0; i < 12; ++i) {  // all through each other
    const Vec3 u = shapes::onCircle(i, 24), v(0, 0, 1), at(5, 0, 0);
    soups::addQuad(cards, {at - u - v, at + u - v, at + u + v, at - u + v});
  }
  const TriangleMesh both = soups::joined({ball, cards});
  const RepairedMesh result = repairedByAuto(both);
  CHECK_FALSE(result.isRemade);
  CHECK(trianglesAt(result.mesh) == trianglesAt(both));
  CHECK(result.report.reason == "sheets");
  CHECK(result.report.selfIntersections[1] == selfIntersections(both).size());
  CHECK(isSaid(result, "SHEETS_LEFT"));
  PartOptions options;
  options.repair = Repair::Auto;
  options.edgeLength = 1;
  options.sheets = Sheets::Drop;
  CHECK(inspectMesh(repairSurface(both, options).mesh).boundaryEdges == 0);
}

TEST_CASE("body_union: many small cards are no debris, and what is given twice is not lost") {
  const TriangleMesh stem = shapes::cube(2);
  TriangleMesh leaves;
  for (int i = 0; i < 100; ++i) {
    const Vec3 at(3.0 + 0.3 * (i % 10), 0.3 * (i / 10), 0);
    soups::addQuad(leaves,
                   {at, at + Vec3(0.2, 0, 0), at + Vec3(0.2, 0.2, 0), at + Vec3(0, 0.2, 0)});
  }
  const TriangleMesh plant = soups::joined({stem, leaves});
  CHECK(holds(repairedByAuto(plant).mesh, plant));
  TriangleMesh twice = stem;
  twice.indices.insert(twice.indices.end(), stem.indices.begin(), stem.indices.end());
  twice.indices.resize(twice.indices.size() - 3);
  const RepairedMesh once = repairedByAuto(twice);
  CHECK(once.report.lost == doctest::Approx(0).epsilon(1e-9));
  CHECK(trianglesAt(once.mesh) == trianglesAt(stem));
}

TEST_CASE("body_union: a body given several times is one body, however it faces") {
  const TriangleMesh ball = shapes::icosphere(2), inwards = shapes::turnedOver(ball);
  for (const TriangleMesh& other : {ball, inwards}) {
    TriangleMesh both = soups::joined({inwards, other});
    CHECK(trianglesAt(repairedByAuto(both).mesh) == trianglesAt(ball));
    both = soups::joined({both, inwards});
    const RepairedMesh result = repairedByAuto(both);
    CHECK(trianglesAt(result.mesh) == trianglesAt(ball));
    CHECK(result.mesh.triangleCount() == ball.triangleCount());
  }
}

TEST_CASE("body_union: bodies whose union is not sound do not spoil the others") {
  const TriangleMesh ball = shapes::icosphere(3), other = soups::moved(ball, {0.7, 0.1, 0.2});
  const std::size_t large = ball.triangleCount() + other.triangleCount();
  soups::Random random(3);
  int unsound = 0;
  for (int trial = 0; trial < 200 && unsound < 2; ++trial) {
    const TriangleMesh plates = soups::moved(turnedPlates(random), {8, 0, 0});
    TriangleMesh bodies = inSinglePrecision(soups::joined({ball, other, plates}));
    // Where attributes are not linear, touching faces are not joined.
    bodies.attributes = {{"TEXCOORD_0", 2, {}}};
    for (std::size_t i = 0; i < 2 * bodies.positions.size(); ++i)
      bodies.attributes[0].values.push_back(float(i * i % 7));
    const std::optional<BodyUnion> found = unionOf(bodies, selfIntersections(bodies), 0);
    REQUIRE(found);
    if (found->undecided.empty()) continue;
    ++unsound;
    CHECK(std::all_of(found->undecided.begin(), found->undecided.end(),
                      [&](Index t) { return t >= large; }));
    CHECK(found->crossings.empty());
    CHECK(countUnbalancedEdges(found->mesh) == 0);
    CHECK(found->parents.size() == found->mesh.triangleCount());
  }
  CHECK(unsound == 2);
}

TEST_CASE("body_union: boxes side by side in turned axes become one body") {
  soups::Random random(7);
  for (int trial = 0; trial < 12; ++trial) {
    CAPTURE(trial);
    const double angle = 3 * random.number();
    const Vec3 axis = random.point(), at = random.point();
    TriangleMesh row;
    for (int i = 0; i < 4; ++i) {
      TriangleMesh box = soups::cube(0, 1);
      for (Vec3& p : box.positions) {
        p = Vec3(i, 0, 0) + p.cwiseProduct(Vec3(1, 1 + 0.5 * (i % 2), 1 + 0.5 * (trial % 2)));
        p = at + Eigen::AngleAxisd(angle, axis.normalized()) * p;
      }
      row = soups::joined({row, box});
    }
    const RepairedMesh result = repairedByAuto(inSinglePrecision(row));
    const MeshReport report = inspectMesh(result.mesh);
    CHECK(report.boundaryEdges + report.nonManifoldEdges == 0);
    CHECK(report.components == 1);
    CHECK(report.eulerCharacteristic == 2);
    CHECK(touchingVertices(Welding(result.mesh)).empty());
  }
}

TEST_CASE("body_union: a body that goes is named with its size and place") {
  TriangleMesh within = shapes::icosphere(2);
  for (Vec3& p : within.positions) p *= 0.25;
  const RepairedMesh result = repairedByAuto(soups::joined({shapes::icosphere(4), within}));
  const auto said = std::find_if(
      result.warnings.begin(), result.warnings.end(),
      [](const PlacedWarning& w) { return w.warning.code == "HIDDEN_BODIES_REMOVED"; });
  REQUIRE(said != result.warnings.end());
  CHECK(said->across == doctest::Approx(0.5 * std::sqrt(3.0)).epsilon(0.1));
  CHECK(said->at->norm() == doctest::Approx(0.25));
}

TEST_CASE("body union: a part that is inside out is not lost where it is seen") {
  // A prism over a figure of eight: one of its lobes faces inwards, and is a little smaller.
  constexpr int kSides = 32;
  const auto at = [](int i, double z) {
    const double u = 2 * std::numbers::pi * ((i % kSides) + 0.5) / kSides;
    return Vec3((std::sin(u) > 0 ? 2 : 1.9) * std::sin(u), std::sin(2 * u), z);
  };
  TriangleMesh eight;
  for (int i = 0; i < kSides; ++i) {
    soups::addQuad(eight, {at(i, 0), at(i + 1, 0), at(i + 1, 1), at(i, 1)});
    soups::addTriangle(eight, at(i + 1, 0), at(i, 0), {0, 0, 0});
    soups::addTriangle(eight, at(i, 1), at(i + 1, 1), {0, 0, 1});
  }
  const RepairedMesh result = repairedByAuto(eight);
  CHECK(result.report.reason == "united");
  const std::vector<Vec3>& all = result.mesh.positions;
  const auto [low, high] = std::minmax_element(
      all.begin(), all.end(), [](const Vec3& p, const Vec3& q) { return p.x() < q.x(); });
  CHECK(low->x() < -1.8);
  CHECK(high->x() > 1.9);
  CHECK(countUnbalancedEdges(result.mesh) == 0);
  CHECK(selfIntersections(result.mesh).empty());
}
