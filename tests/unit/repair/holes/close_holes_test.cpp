// SPDX-License-Identifier: MIT
#include "repair/holes/close_holes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "base/error.h"
#include "measure/mesh_report.h"
#include "measure/self_intersections.h"
#include "repair/stitch.h"
#include "support/hostile_shapes.h"
#include "support/shapes.h"
#include "support/soups.h"
#include "support/volume_of.h"

using namespace remesher;

namespace {

// Without the triangles whose middle fulfils a condition.
template <class Condition>
TriangleMesh without(const TriangleMesh& mesh, Condition isGone) {
  TriangleMesh result = mesh;
  result.indices.clear(), result.groups.clear();
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    Vec3 middle = Vec3::Zero();
    for (std::size_t k = 0; k < 3; ++k) middle += mesh.positions[mesh.indices[i + k]] / 3;
    if (isGone(middle)) continue;
    for (std::size_t k = 0; k < 3; ++k) result.indices.push_back(mesh.indices[i + k]);
    if (!mesh.groups.empty()) result.groups.push_back(mesh.groups[i / 3]);
  }
  return result;
}

TriangleMesh capless(int n, double height) {
  return without(shapes::icosphere(n), [height](const Vec3& p) { return p.z() > height; });
}

bool isClosedManifold(const TriangleMesh& mesh) {
  const MeshReport report = inspectMesh(mesh);
  return report.boundaryEdges == 0 && report.nonManifoldEdges == 0;
}

// Each edge has as many triangles one way as the other; bodies that touch have edges of four.
bool isClosed(const TriangleMesh& mesh) { return countUnbalancedEdges(mesh) == 0; }

// What was there is there, bit for bit and in its order, before all that is new.
void checkUntouched(const TriangleMesh& before, const TriangleMesh& after) {
  REQUIRE(after.positions.size() >= before.positions.size());
  REQUIRE(after.indices.size() >= before.indices.size());
  CHECK(std::equal(before.positions.begin(), before.positions.end(), after.positions.begin()));
  CHECK(std::equal(before.indices.begin(), before.indices.end(), after.indices.begin()));
}

// Of the new vertices, the largest distance from the unit sphere.
double farthestFromSphere(const TriangleMesh& before, const TriangleMesh& after) {
  double farthest = 0;
  for (std::size_t v = before.positions.size(); v < after.positions.size(); ++v)
    farthest = std::max(farthest, std::abs(after.positions[v].norm() - 1));
  return farthest;
}

// A ball of 48 columns that begins so many degrees above its lowest point.
TriangleMesh ballFrom(double degrees) {
  constexpr double kRadian = std::numbers::pi / 180;
  TriangleMesh ball;
  shapes::addSheet(ball, 48, 24, [&](int k, int row) {
    const double angle = row == 24 ? 180 : degrees + (180 - degrees) * row / 24;
    return Vec3(std::sin(angle * kRadian) * shapes::onCircle(k, 48) -
                Vec3(0, 0, std::cos(angle * kRadian)));
  });
  return ball;
}

std::pair<double, double> heights(const TriangleMesh& mesh) {
  std::pair<double, double> range = {kInfinity, -kInfinity};
  for (const Vec3& p : mesh.positions)
    range = {std::min(range.first, p.z()), std::max(range.second, p.z())};
  return range;
}

// A wall over a curve around the z axis.
TriangleMesh wall(int n, int rows, const std::function<Vec3(int, double)>& at) {
  TriangleMesh mesh;
  shapes::addSheet(mesh, n, rows, [&](int k, int row) { return at(k, double(row) / rows); });
  return mesh;
}

Vec3 around(int k, int n, double waves) {
  const double angle = 2 * std::numbers::pi * (k % n) / n;
  return (1 + 0.6 * std::sin(waves * angle)) * shapes::onCircle(k, n);
}

}  // namespace

TEST_CASE("close_holes: a sphere without a cap is a sphere again, the rest bit for bit") {
  const double height = 0.8;
  const TriangleMesh open = capless(12, height);
  const ClosedHoles closed = closeHoles(open);
  CHECK(closed.holes == 1);
  CHECK(closed.trianglesRemoved == 0);
  checkUntouched(open, closed.mesh);
  CHECK(isClosedManifold(closed.mesh));
  CHECK(inspectMesh(closed.mesh).eulerCharacteristic == 2);
  CHECK(selfIntersections(closed.mesh).empty());
  // A flat plug would be off by 1 - height at its middle.
  CHECK(farthestFromSphere(open, closed.mesh) < (1 - height) / 5);
}

TEST_CASE("close_holes: walls that end in a plane end in it when they are closed") {
  const TriangleMesh tube = wall(
      48, 12, [](int k, double up) { return Vec3(shapes::onCircle(k, 48) + Vec3(0, 0, 3 * up)); });
  TriangleMesh jar = wall(40, 8, [](int k, double up) {
    return Vec3((1 - 0.3 * up) * shapes::onCircle(k, 40) + Vec3(0, 0, 1.2 * up));
  });
  for (int k = 0; k < 40; ++k)
    shapes::addTriangle(jar, shapes::addVertex(jar, {0, 0, 0}), Index(k + 1), Index(k));
  // More vertices than tables take, and far from convex.
  const TriangleMesh star =
      wall(600, 3, [](int k, double up) { return Vec3(around(k, 600, 7) + Vec3(0, 0, 0.1 * up)); });
  const TriangleMesh box = without(shapes::cube(1), [](const Vec3& p) { return p.z() == 1; });
  const std::array<std::size_t, 5> loops = {2, 1, 2, 1, 1};
  std::size_t i = 0;
  for (const TriangleMesh& open : {tube, jar, star, box, ballFrom(36)}) {
    CAPTURE(i);
    const ClosedHoles closed = closeHoles(open);
    CHECK(closed.holes == loops[i++]);
    CHECK(isClosedManifold(closed.mesh));
    CHECK(selfIntersections(closed.mesh).empty());
    const auto [least, most] = heights(open);
    const auto [low, high] = heights(closed.mesh);
    CHECK(low == doctest::Approx(least).epsilon(1e-12));
    CHECK(high == doctest::Approx(most).epsilon(1e-12));
  }
}

TEST_CASE("close_holes: a planar loop in a smooth surface is closed smoothly") {
  const TriangleMesh open = ballFrom(20);
  const ClosedHoles closed = closeHoles(open);
  CHECK(closed.holes == 1);
  CHECK(farthestFromSphere(open, closed.mesh) < (1 - std::cos(std::numbers::pi / 9)) / 5);
}

TEST_CASE("close_holes: walls around material that end in one plane get a lid with holes") {
  const auto tube = [](int n, double radius, double x) {
    return wall(n, 2, [=](int k, double up) {
      return Vec3(radius * shapes::onCircle(k, n) + Vec3(x, 0, 3 * up));
    });
  };
  const auto areaAcross = [](int n, double radius) {
    return 0.5 * n * radius * radius * std::sin(2 * std::numbers::pi / n);
  };
  // Two bores, and in one of them a tube.
  const TriangleMesh open = soups::joined({tube(32, 2, 0), shapes::turnedOver(tube(20, 0.7, 1)),
                                           shapes::turnedOver(tube(4, 0.8, -1)), tube(12, 0.5, 1),
                                           shapes::turnedOver(tube(5, 0.3, 1))});
  const ClosedHoles closed = closeHoles(open);
  CHECK(closed.holes == 10);
  checkUntouched(open, closed.mesh);
  CHECK(isClosedManifold(closed.mesh));
  CHECK(selfIntersections(closed.mesh).empty());
  CHECK(inspectMesh(closed.mesh).components == 2);
  CHECK(shapes::volumeOf(closed.mesh) ==
        doctest::Approx(3 * (areaAcross(32, 2) - areaAcross(20, 0.7) - areaAcross(4, 0.8) +
                             areaAcross(12, 0.5) - areaAcross(5, 0.3))));
}

TEST_CASE("close_holes: shells that face the same way get a disk each, also in one plane") {
  const TriangleMesh outer =
      wall(32, 6, [](int k, double up) { return Vec3(shapes::onCircle(k, 32) + Vec3(0, 0, up)); });
  TriangleMesh inner = outer;
  for (Vec3& p : inner.positions) p.x() *= 0.8, p.y() *= 0.8;
  const ClosedHoles closed = closeHoles(soups::joined({outer, inner}));
  CHECK(closed.holes == 4);
  CHECK(inspectMesh(closed.mesh).components == 2);
}

TEST_CASE("close_holes: each loop gets a disk, so that each adds one to the Euler characteristic") {
  const TriangleMesh torus = shapes::torus(24, 12);
  const TriangleMesh open =
      without(torus, [](const Vec3& p) { return std::abs(p.x()) > std::abs(p.y()) * 4; });
  const MeshReport before = inspectMesh(open);
  const ClosedHoles closed = closeHoles(open);
  const MeshReport after = inspectMesh(closed.mesh);
  CHECK(closed.holes == 4);  // two tubes with two ends each
  CHECK(after.eulerCharacteristic == before.eulerCharacteristic + 4);
  CHECK(after.eulerCharacteristic == 4);
  CHECK(isClosedManifold(closed.mesh));
}

TEST_CASE("close_holes: a loop of many edges takes a bounded number of vertices") {
  const int n = 500;
  TriangleMesh band;
  shapes::addSheet(band, n, 1, [&](int k, int row) {
    return Vec3(shapes::onCircle(k, n) + Vec3(0, 0, 0.002 * row));
  });
  const ClosedHoles closed = closeHoles(band);
  CHECK(closed.holes == 2);
  CHECK(isClosedManifold(closed.mesh));
  CHECK(inspectMesh(closed.mesh).eulerCharacteristic == 2);
  // Of one size all over they would be n² / 4π to each loop: 20 thousand.
  CHECK(closed.mesh.positions.size() - band.positions.size() < 2 * 10 * std::size_t{n});
}

TEST_CASE("close_holes: loops longer than asked for stay open") {
  // The rim at height 0.8 has a length of 3.8, that at -0.95 one of 2.
  const TriangleMesh open = without(capless(20, 0.8), [](const Vec3& p) { return p.z() < -0.95; });
  const ClosedHoles closed = closeHoles(open, {3});
  CHECK(closed.holes == 1);
  CHECK(closed.openAt.size() == 1);
  CHECK(inspectMesh(closed.mesh).eulerCharacteristic == 1);
  CHECK(closeHoles(open, {0}).mesh.indices == open.indices);
}

TEST_CASE("close_holes: a scrap in a hole is an island, and goes") {
  const TriangleMesh open = capless(12, 0.8);
  TriangleMesh scrapped = open;
  soups::addTriangle(scrapped, {0, 0, 1}, {0.1, 0, 1}, {0, 0.1, 1});
  const ClosedHoles closed = closeHoles(scrapped);
  CHECK(closed.islands == 1);
  CHECK(closed.trianglesRemoved == 1);
  CHECK(inspectMesh(closed.mesh).components == 1);
  CHECK(isClosedManifold(closed.mesh));
}

TEST_CASE("close_holes: triangles without three distinct corners are no scraps") {
  TriangleMesh open = capless(12, 0.8);
  open.indices.insert(open.indices.end(), {0, 1, 1, 2, 2, 2});
  const ClosedHoles closed = closeHoles(open);
  CHECK(closed.trianglesRemoved == 0);
  CHECK(closed.lines == 2);
}

TEST_CASE("close_holes: closed bodies that touch in a point or an edge stay as they are") {
  for (const TriangleMesh& touching :
       {shapes::cubesSharingACorner(4), shapes::cubesSharingAnEdge(4)}) {
    const ClosedHoles closed = closeHoles(touching);
    CHECK(closed.trianglesRemoved == 0);
    CHECK(closed.mesh.indices == touching.indices);
    CHECK(closed.mesh.positions == touching.positions);
  }
}

TEST_CASE("close_holes: the group of a disk is that of its loop, whatever was removed before") {
  TriangleMesh open = capless(8, 0.5);
  open.groups.assign(open.triangleCount(), 3);
  TriangleMesh debris;  // before the surface, so that its triangles have other numbers once removed
  for (int i = 0; i < 20; ++i)
    soups::addTriangle(debris, {4.0 + i, 0, 0}, {4.01 + i, 0, 0}, {4.0 + i, 0.01, 0});
  debris.groups.assign(debris.triangleCount(), 7);
  TriangleMesh both = soups::joined({debris, open});
  both.groups.assign(debris.triangleCount(), 7);
  both.groups.resize(both.triangleCount(), 3);
  const ClosedHoles closed = closeHoles(both);
  CHECK(closed.islands == 20);
  CHECK(closed.mesh.groups == std::vector<Index>(closed.mesh.triangleCount(), 3));
}

TEST_CASE("close_holes: whatever hangs together somehow becomes closed") {
  std::vector<TriangleMesh> meshes = {
      shapes::kleinBottle(12, 8),
      shapes::book(5, 3),
      shapes::wheel(9),
      shapes::annulus(16),
      shapes::spikedSphere(6, 5),
      shapes::moebiusStrip(20),
      soups::joined({shapes::cube(2), soups::randomSoup(40, 0.5, 7)})};
  for (const shapes::Shape& shape : shapes::all()) meshes.push_back(shape.mesh);
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    CAPTURE(i);
    const ClosedHoles closed = closeHoles(meshes[i]);
    CHECK(isClosed(closed.mesh));
  }
}

TEST_CASE("close_holes: a single triangle becomes a thin solid, whose edges are shared by two") {
  TriangleMesh triangle;
  soups::addTriangle(triangle, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const ClosedHoles closed = closeHoles(triangle);
  CHECK(isClosedManifold(closed.mesh));
  CHECK(inspectMesh(closed.mesh).eulerCharacteristic == 2);
}

TEST_CASE("close_holes: a lid along straight edges has no triangle without area") {
  for (const TriangleMesh& strip : {shapes::grid(1, 6), shapes::grid(5, 2)}) {
    const ClosedHoles closed = closeHoles(strip, {});
    CHECK(isClosed(closed.mesh));
    CHECK(haveAreas(closed.mesh));
  }
}

TEST_CASE("close_holes: a plug has the group and the values of most of its loop") {
  TriangleMesh open = capless(8, 0.5);
  open.groups.assign(open.triangleCount(), 3);
  Attribute color{"COLOR_0", 3, {}}, joints{"JOINTS_0", 4, {}};
  for (std::size_t v = 0; v < open.positions.size(); ++v) {
    color.values.insert(color.values.end(), {0.25F, 0.5F, 1});
    joints.values.insert(joints.values.end(), {7, 5, 0, 0});
  }
  open.attributes = {color, joints};
  const TriangleMesh closed = closeHoles(open).mesh;
  REQUIRE(closed.positions.size() > open.positions.size());
  CHECK(closed.groups == std::vector<Index>(closed.triangleCount(), 3));
  REQUIRE(closed.attributes[0].values.size() == 3 * closed.positions.size());
  REQUIRE(closed.attributes[1].values.size() == 4 * closed.positions.size());
  CHECK(closed.attributes[0].values.back() == doctest::Approx(1));
  CHECK(closed.attributes[1].values[4 * open.positions.size()] == 7);
}

TEST_CASE("close_holes: no triangle of a plug mixes vertices of two groups") {
  TriangleMesh open = capless(8, 0.5);
  // Two groups with vertices of their own: the vertices of triangles at x < 0 once more.
  const std::size_t count = open.positions.size();
  for (std::size_t v = 0; v < count; ++v) open.positions.push_back(open.positions[v]);
  for (std::size_t i = 0; i < open.indices.size(); i += 3) {
    double x = 0;
    for (std::size_t k = 0; k < 3; ++k) x += open.positions[open.indices[i + k]].x();
    open.groups.push_back(x < -0.3 ? 1 : 0);
    for (std::size_t k = 0; k < 3 && x < -0.3; ++k) open.indices[i + k] += Index(count);
  }
  Attribute mark{"_MARK", 1, {}};
  for (std::size_t v = 0; v < 2 * count; ++v) mark.values.push_back(v < count ? 0 : 1);
  open.attributes = {mark};
  const TriangleMesh closed = closeHoles(open).mesh;
  for (std::size_t i = open.indices.size(); i < closed.indices.size(); ++i)
    CHECK(closed.attributes[0].values[closed.indices[i]] == closed.groups[i / 3]);
}

TEST_CASE("close_holes: the rings of a lid have the values of their walls, whatever their groups") {
  const auto tube = [](double radius) {
    return wall(16, 2, [=](int k, double up) {
      return Vec3(radius * shapes::onCircle(k, 16) + Vec3(0, 0, up));
    });
  };
  TriangleMesh open = soups::joined({tube(2), shapes::turnedOver(tube(1))});
  for (std::size_t t = 0; t < open.triangleCount(); ++t)
    open.groups.push_back(2 * t < open.triangleCount() ? 0 : 1);
  // On both walls a value that goes around.
  Attribute mark{"_MARK", 1, {}};
  for (const Vec3& p : open.positions) mark.values.push_back(float(p.x() + 10 * p.y()));
  open.attributes = {mark};
  const ClosedHoles closed = closeHoles(open);
  CHECK(closed.holes == 4);
  CHECK(isClosedManifold(closed.mesh));
  for (std::size_t i = open.indices.size(); i < closed.mesh.indices.size(); ++i) {
    const Vec3& p = closed.mesh.positions[closed.mesh.indices[i]];
    CHECK(closed.mesh.groups[i / 3] == 0);
    if (std::abs(p.head<2>().norm() - 1) < 1e-9 || std::abs(p.head<2>().norm() - 2) < 1e-9)
      CHECK(closed.mesh.attributes[0].values[closed.mesh.indices[i]] ==
            doctest::Approx(p.x() + 10 * p.y()));
  }
}
