// SPDX-License-Identifier: MIT
#include "repair/solid/solid.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "geometry/triangle_tree.h"
#include "measure/hausdorff.h"
#include "measure/mesh_report.h"
#include "measure/self_intersections.h"
#include "support/hostile_shapes.h"
#include "support/shapes.h"
#include "support/soups.h"

using namespace remesher;

namespace {

double volume(const TriangleMesh& mesh) {
  double sum = 0;
  const auto at = [&](std::size_t i) -> Vec3 {
    return mesh.positions[mesh.indices[i]] - mesh.positions.front();
  };
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
    sum += at(i).dot(at(i + 1).cross(at(i + 2))) / 6;
  return sum;
}

// The promise: closed, 2-manifold, facing outwards, passing through itself nowhere.
void checkPromise(const TriangleMesh& mesh) {
  const MeshReport report = inspectMesh(mesh);
  CHECK(report.boundaryEdges == 0);
  CHECK(report.nonManifoldEdges == 0);
  CHECK(volume(mesh) > 0);
  CHECK(selfIntersections(mesh).empty());
}

TriangleMesh scaledBy(TriangleMesh mesh, double by) {
  for (Vec3& p : mesh.positions) p *= by;
  return mesh;
}

}  // namespace

TEST_CASE("solid: a sphere stays one") {
  const Solid solid = solidOf(shapes::icosphere(10), {0.1});
  checkPromise(solid.mesh);
  CHECK(inspectMesh(solid.mesh).eulerCharacteristic == 2);
  CHECK(solid.enclosure.lost == 0);
  CHECK(solid.loss.share == 0);
  CHECK(solid.loss.places.empty());
  CHECK(solid.enclosure.turned == 0);
  CHECK(volume(solid.mesh) == doctest::Approx(volume(shapes::icosphere(10))).epsilon(0.01));
}

TEST_CASE("solid: overlapping bodies become one, whichever way they face") {
  const TriangleMesh one = shapes::icosphere(8), other = soups::moved(one, {1, 0.1, 0.2});
  const Solid asGiven = solidOf(soups::joined({one, other}), {0.1});
  const Solid halfTurned = solidOf(soups::joined({one, shapes::turnedOver(other)}), {0.1});
  checkPromise(asGiven.mesh);
  CHECK(inspectMesh(asGiven.mesh).components == 1);
  CHECK(inspectMesh(asGiven.mesh).eulerCharacteristic == 2);
  CHECK(halfTurned.enclosure.turned == other.triangleCount());
  CHECK(halfTurned.mesh.positions == asGiven.mesh.positions);
}

TEST_CASE("solid: without attributes all bodies of the input share the surface's vertices") {
  const TriangleMesh one = shapes::icosphere(8), other = soups::moved(one, {1, 0.1, 0.2});
  const TriangleMesh mesh = solidOf(soups::joined({one, other}), {0.1}).mesh;
  std::set<std::pair<Index, Index>> sides;
  for (std::size_t i = 0; i < mesh.indices.size(); ++i)
    sides.insert({mesh.indices[i], mesh.indices[i % 3 == 2 ? i - 2 : i + 1]});
  CHECK(sides.size() == mesh.indices.size());
  for (const auto& [from, to] : sides) CHECK(sides.count({to, from}) == 1);
}

TEST_CASE("solid: shells within a body are gone") {
  const TriangleMesh outer = shapes::icosphere(8), inner = scaledBy(outer, 0.5);
  for (const TriangleMesh& shell : {inner, shapes::turnedOver(inner)}) {
    const Solid solid = solidOf(soups::joined({outer, shell}), {0.1});
    checkPromise(solid.mesh);
    CHECK(solid.enclosure.shells == 1);
    CHECK(inspectMesh(solid.mesh).components == 1);
    CHECK(volume(solid.mesh) == doctest::Approx(volume(outer)).epsilon(0.01));
  }
}

TEST_CASE("solid: cavities stay where they are asked for, and what lies in them") {
  const TriangleMesh ball = shapes::icosphere(6);
  const TriangleMesh wall = shapes::turnedOver(scaledBy(shapes::icosphere(6), 0.7));
  const TriangleMesh core = scaledBy(shapes::icosphere(4), 0.3);
  SolidRule rule{0.08};
  rule.keepsCavities = true;
  const Solid hollow = solidOf(soups::joined({ball, wall}), rule);
  checkPromise(hollow.mesh);
  CHECK(inspectMesh(hollow.mesh).components == 2);
  CHECK(volume(hollow.mesh) == doctest::Approx(volume(ball) + volume(wall)).epsilon(0.02));
  CHECK(hollow.enclosure.shells == 0);
  const Solid filled = solidOf(soups::joined({ball, core, wall}), rule);
  CHECK(inspectMesh(filled.mesh).components == 3);
  CHECK(filled.enclosure.shells == 0);
  // What faces outwards within a body is no cavity.
  const Solid solid = solidOf(soups::joined({ball, core}), rule);
  CHECK(inspectMesh(solid.mesh).components == 1);
  CHECK(solid.enclosure.shells == 1);
}

TEST_CASE("solid: sharp edges are kept") {
  // Turned, so that no side lies along the lattice.
  TriangleMesh cube = soups::cube(-1, 1);
  const Eigen::AngleAxisd turn(0.5, Vec3(1, 2, 3).normalized());
  for (Vec3& p : cube.positions) p = turn * p;
  const double spacing = 0.06;
  const Solid solid = solidOf(cube, {spacing});
  checkPromise(solid.mesh);
  // Of a lattice alone edges would be off by a third of a cell: 0.6 % of the diagonal.
  const DeviationBothWays d = measureDeviation(cube, solid.mesh, Maximum::Sampled);
  CHECK(d.toResult.rms / d.diagonal < 0.0005);
  CHECK(volume(solid.mesh) == doctest::Approx(8).epsilon(0.001));
  // Along the edges, away from the corners: where an edge leaves a cell it is kept as well. Cut
  // straight there it would be off by an eighth of a cell. So it is where it leaves within the
  // margin of the face's rim, 2 % on each of four sides: sqrt(0.08) / 8 = 1 / 28.
  const TriangleTree tree(solid.mesh.positions, solid.mesh.indices);
  double sum = 0;
  int count = 0;
  for (const double y : {-1.0, 1.0})
    for (const double z : {-1.0, 1.0})
      for (double x = -0.9; x < 0.9; x += 0.0037, ++count)
        sum += tree.nearest(turn * Vec3(x, y, z)).squaredDistance;
  CHECK(std::sqrt(sum / count) < spacing / 28);
}

TEST_CASE("solid: blunt edges between large facets are kept where nothing is remeshed") {
  constexpr double kCell = 0.03;
  SolidRule rule{kCell};
  rule.cleaning = Cleaning::Thorough;
  const TriangleMesh input = shapes::icosphere(2);  // 18° to 24° between facets
  const Solid solid = solidOf(input, rule);
  checkPromise(solid.mesh);
  const TriangleTree tree(solid.mesh.positions, solid.mesh.indices);
  double squares = 0, count = 0;
  for (std::size_t i = 0; i < input.indices.size(); ++i) {
    const Vec3& a = input.positions[input.indices[i]];
    const Vec3& b = input.positions[input.indices[i % 3 == 2 ? i - 2 : i + 1]];
    for (double t = 0.05; t < 1; t += 0.1, ++count)
      squares += tree.nearest(a + t * (b - a)).squaredDistance;
  }
  CHECK(std::sqrt(squares / count) < 0.01 * kCell);
}

TEST_CASE("solid: no vertex stands out from facets that meet in one") {
  const TriangleMesh input = shapes::icosphere(2);
  const TriangleTree tree(input.positions, input.indices);
  for (const double cell : {0.03, 0.031, 0.043, 0.06}) {
    SolidRule rule{cell};
    rule.cleaning = Cleaning::Thorough;
    double farthest = 0;
    for (const Vec3& p : solidOf(input, rule).mesh.positions)
      farthest = std::max(farthest, std::sqrt(tree.nearest(p).squaredDistance));
    CHECK(farthest < 0.5 * cell * std::tan(radians(12)));  // the rise of a facet in half a cell
  }
}

TEST_CASE("solid: the promise holds in single precision, however far away") {
  for (const double offset : {1e3, 1e5, 1e6, 1e7}) {
    CAPTURE(offset);
    TriangleMesh mesh = soups::joined({shapes::icosphere(4), soups::cube(0.3, 1.4)});
    mesh.isSingle = true;
    for (Vec3& p : mesh.positions) p = inSingle(p + Vec3(offset, 0.1 * offset, 0), {});
    const Solid solid = solidOf(mesh, {0.05, InsideBy::Reach, 0.1});
    if (offset < 1e7) CHECK(!solid.mesh.indices.empty());
    if (solid.mesh.indices.empty()) continue;
    checkPromise(solid.mesh);
    CHECK(inspectMesh(solid.mesh).degenerateTriangles == 0);
    for (const Vec3& p : solid.mesh.positions) CHECK(p == inSingle(p, {}));
  }
}

TEST_CASE("solid: the promise holds whatever is given, both ways") {
  std::vector<TriangleMesh> meshes = {
      shapes::kleinBottle(12, 8),     shapes::book(5, 3),
      shapes::moebiusStrip(20),       shapes::cubesSharingAnEdge(3),
      shapes::cubesSharingACorner(3), shapes::spikedSphere(6, 3),
      soups::randomSoup(300, 0.5, 7), soups::joined({soups::cube(0, 1), soups::cube(0.2, 0.7)})};
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    double size = 0;
    for (const Vec3& p : meshes[i].positions) size = std::max(size, p.norm());
    for (const SolidRule& rule :
         {SolidRule{size / 20}, SolidRule{size / 20, InsideBy::Reach, size / 15}}) {
      CAPTURE(i);
      const Solid solid = solidOf(meshes[i], rule);
      if (rule.by == InsideBy::Reach) CHECK(!solid.mesh.indices.empty());
      if (!solid.mesh.indices.empty()) checkPromise(solid.mesh);
    }
  }
}

TEST_CASE("solid: in single precision nothing moves when it is written") {
  TriangleMesh mesh =
      soups::joined({shapes::icosphere(6), soups::moved(shapes::cube(3), {0.3, 0, 0})});
  mesh.isSingle = true;
  for (Vec3& p : mesh.positions) p = inSingle(p, {});
  const TriangleMesh solid = solidOf(mesh, {0.13}).mesh;
  for (const Vec3& p : solid.positions) REQUIRE(p == inSingle(p, {}));
  checkPromise(solid);
}

TEST_CASE("solid: a sheet reached from both sides becomes a thin solid, its front where it was") {
  TriangleMesh sheet;
  shapes::addSheet(sheet, 10, 10, [](int x, int y) { return Vec3(0.1 * x, 0.1 * y, 0.013 * x); });
  const double spacing = 0.03;
  const Solid solid = solidOf(sheet, {spacing, InsideBy::Reach, 0.05});
  checkPromise(solid.mesh);
  const DeviationBothWays d = measureDeviation(sheet, solid.mesh, Maximum::Sampled);
  CHECK(d.toResult.rms < spacing / 5);
  CHECK(d.toOriginal.maximum < 2 * spacing);
}

TEST_CASE("solid: the outside does not fray a surface through its cracks") {
  // A sphere whose triangles have cracks between them.
  TriangleMesh cracked;
  const TriangleMesh sphere = soups::sphere(12);
  for (std::size_t i = 0; i < sphere.indices.size(); i += 3) {
    const auto at = [&](std::size_t k) { return sphere.positions[sphere.indices[i + k]]; };
    const Vec3 middle = (at(0) + at(1) + at(2)) / 3;
    const auto shrunk = [&](std::size_t k) -> Vec3 { return 0.9 * at(k) + 0.1 * middle; };
    soups::addTriangle(cracked, shrunk(0), shrunk(1), shrunk(2));
  }
  for (const double spacing : {0.025, 0.03}) {
    const Solid solid = solidOf(cracked, {spacing, InsideBy::Reach, 0.1});
    CHECK(measureDeviation(cracked, solid.mesh, Maximum::Sampled).toOriginal.rms < spacing / 2);
  }
}

TEST_CASE("solid: sheets beside a body are dropped where that is asked for") {
  const TriangleMesh ball = shapes::icosphere(6);
  const TriangleMesh both = soups::joined({ball, soups::moved(shapes::grid(4, 4), {3, 0, 0})});
  SolidRule rule{0.1, InsideBy::Reach, 0.3};
  const Solid thick = solidOf(both, rule);
  CHECK(inspectMesh(thick.mesh).components == 2);
  CHECK(thick.enclosure.sheets == 1);
  rule.sheets = Sheets::Drop;
  const Solid alone = solidOf(both, rule);
  checkPromise(alone.mesh);
  CHECK(inspectMesh(alone.mesh).components == 1);
  CHECK(alone.enclosure.sheets == 1);
  CHECK(alone.enclosure.lost > 0);
  CHECK(alone.loss.share > 0);
  CHECK(alone.loss.places.front().x() > 1.5);
}

TEST_CASE("solid: groups and values come from the triangles that are seen") {
  const TriangleMesh outer = shapes::icosphere(6), inner = scaledBy(outer, 0.6);
  TriangleMesh both = soups::joined({outer, inner});
  for (std::size_t t = 0; t < both.triangleCount(); ++t)
    both.groups.push_back(t < outer.triangleCount() ? 0 : 1);
  Attribute mark{"_MARK", 1, {}};
  for (std::size_t v = 0; v < both.positions.size(); ++v)
    mark.values.push_back(v < outer.positions.size() ? 2 : 5);
  both.attributes = {mark};
  const TriangleMesh solid = solidOf(both, {0.1}).mesh;
  CHECK(solid.groups == std::vector<Index>(solid.triangleCount(), 0));
  REQUIRE(solid.attributes[0].values.size() == solid.positions.size());
  for (const float value : solid.attributes[0].values) CHECK(value == doctest::Approx(2));
}
