// SPDX-License-Identifier: MIT
#include "original/curves/flat_regions.h"

#include <doctest/doctest.h>

#include <set>

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
