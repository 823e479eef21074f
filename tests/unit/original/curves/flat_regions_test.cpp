// SPDX-License-Identifier: MIT
#include "original/curves/flat_regions.h"

#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "mesh/mesh_builder.h"
#include "original/curves/facets.h"
#include "original/curves/shape_angles.h"
#include "support/parts.h"
#include "support/surfaces.h"

using namespace remesher;

namespace {

FlatRegions regionsOf(const surfaces::Surface& surface, double width) {
  return findFlatRegions(surface.mesh(), surface.positions(), width);
}

std::size_t countRegions(const TriangleMesh& mesh, double width) {
  return regionsOf(surfaces::surface("", mesh), width).widths.size();
}

// As many files have it: turned by odd angles, each coordinate with six digits.
TriangleMesh turnedInSixDigits(TriangleMesh mesh, double angle) {
  const Eigen::AngleAxisd turn(angle, Vec3(1, 2, 3).normalized());
  for (Vec3& p : mesh.positions) {
    p = turn * (20 * p);
    for (double& x : p) {
      const double step = x == 0 ? 1 : std::pow(10.0, std::floor(std::log10(std::abs(x))) - 5);
      x = step * std::round(x / step);
    }
  }
  return mesh;
}

}  // namespace

TEST_CASE("flat regions: the sides of bodies, and none of what is round") {
  CHECK(countRegions(shapes::cube(4), 0.1) == 6);
  CHECK(countRegions(shapes::boxWithHole(), 0.1) == 6 + 4);
  CHECK(countRegions(shapes::icosphere(8), 0) == 0);
  CHECK(countRegions(shapes::grid(6, 6), 0.1) == 1);
  // The bottom, the top, two sides, two ends; the facets of the fillets are a sixteenth as wide.
  CHECK(countRegions(shapes::filletedBar(8), 0.2) == 6);
  CHECK(countRegions(shapes::filletedBar(8), 0) == 6);
  CHECK(countRegions(shapes::torus(48, 24), 0) == 0);
}

TEST_CASE("flat regions: the ends of a bar of facets, however small a share of it they are") {
  std::vector<Vec2> outline;
  for (int k = 0; k < 48; ++k) outline.push_back(shapes::onCircle(k, 48).head<2>());
  for (const double length : {2.0, 10.0, 40.0})
    CHECK(countRegions(shapes::extruded(outline, length), 0) == 2);
}

TEST_CASE("flat regions: their borders need no angle") {
  const surfaces::Surface bar = surfaces::surface("", shapes::filletedBar(40));
  double length = 0;
  for (const Halfedge h : bordersOf(regionsOf(bar, 0.2), bar.mesh())) {
    const Vec3 &a = bar.positions()[bar.mesh().origin(h)], &b = bar.positions()[bar.mesh().tip(h)];
    if (a.z() == 0 && b.z() == 0) length += distance(a, b);
  }
  const double width = shapes::kBarWidth - 2 * shapes::kFilletRadius;
  CHECK(length == doctest::Approx(2 * (shapes::kBarLength + width)));
}

TEST_CASE("flat regions: what is a little bent is not flat, what is rounded to floats is") {
  TriangleMesh mesh = shapes::grid(20, 20);
  for (Vec3& p : mesh.positions) p += Vec3(0, 0, 0.3 * p.x() + 0.7 * p.y());
  for (Vec3& p : mesh.positions) p = p.cast<float>().cast<double>();
  CHECK(countRegions(mesh, 0.1) == 1);
  for (Vec3& p : mesh.positions) p.z() += 1e-3 * p.x() * p.x() * p.y();
  CHECK(countRegions(mesh, 0.5) == 0);
}

TEST_CASE("flat regions: a part has as many where it is turned and written with six digits") {
  for (const TriangleMesh& part :
       {shapes::filletedBar(8), shapes::drilledPlate(16, 0.5), shapes::boxWithHole()})
    for (int i = 0; i < 6; ++i) {
      const TriangleMesh written = turnedInSixDigits(part, 0.3 + 0.7 * i);
      CAPTURE(i);
      CHECK(countRegions(written, 0) == countRegions(part, 0));
      const surfaces::Surface surface = surfaces::surface("", written);
      CHECK(coplanarShare(surface.mesh(), surface.positions()) > 0.95);
    }
}

TEST_CASE("flat regions: all quads of a tower of prisms are facets, with fixed decimals as well") {
  const auto facetsOf = [](const TriangleMesh& mesh) {
    const BuiltMesh built = buildMesh(mesh);
    const FaceData<Index> facets =
        findFacets(built.mesh, built.positions, flatTolerance(built.mesh, built.positions));
    return std::set<Index>(facets.values().begin(), facets.values().end()).size();
  };
  const TriangleMesh tower = shapes::cylinder(24, 12);
  for (const double angle : {0.3, 0.8, 1.9, 2.6}) {
    TriangleMesh turned = tower;
    for (Vec3& p : turned.positions) {
      p = Eigen::AngleAxisd(angle, Vec3(1, 2, 3).normalized()) * p;
      for (double& x : p) x = 1.37 * std::round(1e5 * x) / 1e5;  // of another unit of length
    }
    CHECK(facetsOf(turned) == facetsOf(tower));
  }
}

TEST_CASE("flat regions: a triangle without area belongs to what its longest edge lies against") {
  // The corner in the middle of an edge of a cube is the third of a triangle that is a line.
  TriangleMesh mesh = shapes::cube(1);
  const std::size_t triangles = mesh.indices.size() / 3;
  const Index middle = shapes::addVertex(
      mesh, 0.5 * (mesh.positions[mesh.indices[0]] + mesh.positions[mesh.indices[1]]));
  const Index a = mesh.indices[0], b = mesh.indices[1], c = mesh.indices[2];
  mesh.indices[1] = middle;
  shapes::addTriangle(mesh, middle, b, c);
  shapes::addTriangle(mesh, a, b, middle);
  REQUIRE(mesh.indices.size() / 3 == triangles + 2);
  const surfaces::Surface cube = surfaces::surface("", mesh);
  const FlatRegions regions = regionsOf(cube, 0.1);
  CHECK(regions.widths.size() == 6);
  CHECK(std::set<Index>(regions.of.values().begin(), regions.of.values().end()).count(kNone) == 0);
}
