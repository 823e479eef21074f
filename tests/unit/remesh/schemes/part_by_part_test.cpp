// SPDX-License-Identifier: MIT
#include "remesh/schemes/part_by_part.h"

#include <doctest/doctest.h>

#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "base/place.h"
#include "geometry/extent.h"
#include "support/shapes.h"

using namespace remesher;

namespace {

void add(TriangleMesh& mesh, const TriangleMesh& part, double scale, const Vec3& shift) {
  const auto first = Index(mesh.positions.size());
  for (const Vec3& p : part.positions) mesh.positions.push_back(scale * p + shift);
  for (const Index v : part.indices) mesh.indices.push_back(first + v);
}

// A ball that no plane mirrors, and so many tiny cones beside it.
TriangleMesh bodyWithCones(int cones) {
  TriangleMesh mesh, ball = shapes::icosphere(12);
  for (Vec3& p : ball.positions)
    p = p.cwiseProduct(Vec3(1, 1.2, 1.5)) + 0.1 * std::sin(3 * p.x() + 2 * p.y()) * p;
  add(mesh, ball, 1, Vec3::Zero());
  for (int i = 0; i < cones; ++i) add(mesh, shapes::cone(8), 0.03, Vec3(2 + 0.2 * i, 0.1 * i, 0));
  return mesh;
}

// Vertices with x below the bound that are not in four quads.
std::size_t irregularBelow(const TriangleMesh& mesh, double bound) {
  std::map<std::tuple<double, double, double>, int> quads;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 6)
    for (const std::size_t k : {0, 1, 2, 5}) {
      const Vec3& p = mesh.positions[mesh.indices[i + k]];
      if (p.x() < bound) ++quads[{p.x(), p.y(), p.z()}];
    }
  std::size_t count = 0;
  for (const auto& one : quads) count += one.second != 4;
  return count;
}

RemeshOutcome quadsOf(const TriangleMesh& mesh, Index vertices) {
  PartOptions options;
  options.quads = true;
  options.vertices = vertices;
  return remeshSurface(mesh, options, {});
}

std::vector<SurfacePart> partsOf(const TriangleMesh& mesh, const PartOptions& options = {}) {
  return surfaceParts(mesh, buildMesh(mesh), options);
}

}  // namespace

TEST_CASE("part by part: a body beside tiny parts is as regular as alone") {
  const RemeshOutcome alone = quadsOf(bodyWithCones(0), 600);
  for (const int cones : {1, 6}) {
    CAPTURE(cones);
    const RemeshOutcome made = quadsOf(bodyWithCones(cones), 600);
    CHECK(irregularBelow(made.mesh, 1.9) <= irregularBelow(alone.mesh, 1.9));
    CHECK(made.quadParts == std::size_t(cones) + 1);
    CHECK(made.vertices >= 600 * 0.96);
    CHECK(made.vertices <= 600 * 1.04);
  }
}

TEST_CASE("part by part: shares are by area and add up to the whole, the smallest first") {
  TriangleMesh mesh;
  add(mesh, shapes::cube(2), 2, Vec3::Zero());
  add(mesh, shapes::cube(2), 1, Vec3(9, 0, 0));
  const std::vector<SurfacePart> parts = partsOf(mesh);
  REQUIRE(parts.size() == 2);
  CHECK(parts[0].share == doctest::Approx(0.2));
  CHECK(parts[1].share == doctest::Approx(0.8));
  for (const SurfacePart& part : parts)
    for (std::size_t i = 0; i < part.mesh.indices.size(); ++i) {
      const Index whole = mesh.indices[3 * part.triangles[i / 3] + i % 3];
      CHECK(part.vertices[part.mesh.indices[i]] == whole);
      CHECK(part.mesh.positions[part.mesh.indices[i]] == mesh.positions[whole]);
    }
}

TEST_CASE("part by part: parts that a plane mirrors onto each other are one") {
  TriangleMesh mesh;
  add(mesh, shapes::icosphere(4), 2, Vec3::Zero());
  for (const double x : {-3.0, 3.0}) add(mesh, shapes::icosphere(3), 0.5, Vec3(x, 0.4, 0.3));
  const std::vector<SurfacePart> parts = partsOf(mesh);
  REQUIRE(parts.size() == 2);
  CHECK(parts[0].mesh.triangleCount() == 2 * shapes::icosphere(3).triangleCount());
  PartOptions off;
  off.symmetry = Symmetry::Off;
  CHECK(partsOf(mesh, off).size() == 3);
}

TEST_CASE("part by part: the planes counted mirror all parts") {
  TriangleMesh mesh;
  add(mesh, shapes::cube(2), 2, Vec3(-2, -2, -2));
  add(mesh, shapes::cube(2), 1, Vec3(5, -0.5, -1));
  const RemeshOutcome made = quadsOf(mesh, 300);
  CHECK(made.mirrors.size() > 0);
  std::set<std::tuple<double, double, double>> places;
  for (const Vec3& p : made.mesh.positions) places.insert({p.x(), p.y(), p.z()});
  for (const MirrorPlane& plane : made.mirrors)
    for (const Vec3& p : made.mesh.positions) {
      const Vec3 image = plane.mirrored(p);
      CHECK(places.contains({image.x(), image.y(), image.z()}));
    }
}

TEST_CASE("part by part: attributes and groups of each part come with it") {
  TriangleMesh mesh = bodyWithCones(2);
  mesh.groups.assign(mesh.triangleCount(), 0);
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t)
    mesh.groups[t] = mesh.positions[mesh.indices[3 * t]].x() > 1.9 ? 1 : 0;
  Attribute colours{"COLOR_0", 3, {}};
  for (const Vec3& p : mesh.positions)
    colours.values.insert(colours.values.end(), 3, p.x() > 1.9 ? 1.0F : 0.0F);
  mesh.attributes = {colours};
  const RemeshOutcome made = quadsOf(mesh, 500);
  REQUIRE(made.mesh.groups.size() == made.mesh.triangleCount());
  REQUIRE(made.mesh.attributes.size() == 1);
  REQUIRE(made.mesh.attributes[0].values.size() == 3 * made.mesh.positions.size());
  for (std::size_t i = 0; i < made.mesh.indices.size(); ++i) {
    const Index v = made.mesh.indices[i];
    const bool isCone = made.mesh.positions[v].x() > 1.9;
    CHECK(made.mesh.groups[i / 3] == Index(isCone));
    CHECK(made.mesh.attributes[0].values[std::size_t{3} * v] == (isCone ? 1 : 0));
  }
}

TEST_CASE("part by part: places that parts share count once") {
  TriangleMesh mesh;  // two cubes with a common edge
  const TriangleMesh cube = shapes::cube(4);
  const Vec3 size = extentOf(cube).sides;
  add(mesh, cube, 1, Vec3::Zero());
  add(mesh, cube, 1, Vec3(size.x(), size.y(), 0));
  PartOptions options;
  options.quads = true;
  options.vertices = 120;
  const RemeshOutcome made = remeshSurface(mesh, options, {});
  CHECK(made.vertices == countPlaces(made.mesh.positions));
}

TEST_CASE("part by part: an exact number is that of all parts together") {
  PartOptions options;
  options.quads = options.exact = true;
  options.vertices = 701;
  const RemeshOutcome made = remeshSurface(bodyWithCones(3), options, {});
  CHECK(made.vertices == 701);
}
