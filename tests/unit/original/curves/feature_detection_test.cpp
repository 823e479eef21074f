// SPDX-License-Identifier: MIT
#include "original/curves/feature_detection.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/random.h"
#include "support/soups.h"
#include "support/surfaces.h"

using namespace remesher;

namespace {

// A roof over the x axis whose ridge is bent by `sharp` degrees at x = 0 and flat at x = length.
TriangleMesh fadingRoof(int length, double sharp) {
  TriangleMesh mesh;
  shapes::addSheet(mesh, length, 8, [&](int x, int y) {
    const double slope = std::tan(radians(0.5 * sharp * (1 - double(x) / length)));
    return Vec3(x, y - 4, -slope * std::abs(y - 4));
  });
  return mesh;
}

std::vector<Halfedge> detect(const surfaces::Surface& surface, double size) {
  return detectFeatures(surface.mesh(), surface.positions(), {40, size});
}

}  // namespace

TEST_CASE(
    "feature detection: the edges of bodies with flat and round faces, no more and no fewer") {
  const auto count = [](const TriangleMesh& mesh) {
    return detect(surfaces::surface("", mesh), 0.1).size();
  };
  CHECK(count(shapes::cube(4)) == 12 * 4);
  CHECK(count(shapes::boxWithHole()) == 12 * 3 + 4 * 3 + 2 * 4);
  CHECK(count(shapes::cylinder(40, 6)) == 2 * 40);
  CHECK(count(shapes::cone(40)) == 40);
  CHECK(count(shapes::icosphere(6)) == 0);
  CHECK(count(shapes::torus(30, 20)) == 0);
}

TEST_CASE("feature detection: a network shorter than a few target edges is none") {
  CHECK(detect(surfaces::surface("", shapes::cube(4)), 20).empty());
}

TEST_CASE("feature detection: noise is not taken for features") {
  Random random(5);
  TriangleMesh mesh = shapes::icosphere(20);
  for (Vec3& p : mesh.positions) p *= 1 + 0.02 * random.uniform();
  CHECK(detect(surfaces::surface("", mesh), 0.1).empty());
}

TEST_CASE("feature detection: where nearly all that is sharp is a part's, so is a rough crease") {
  Random random(3);
  TriangleMesh crease = fadingRoof(40, 80);
  for (Vec3& p : crease.positions) p.z() += 0.15 * random.uniform();
  crease = soups::moved(crease, Vec3(20, 0, 0));
  const auto count = [](std::initializer_list<TriangleMesh> bodies) {
    return detect(surfaces::surface("", soups::joined(bodies)), 1).size();
  };
  CHECK(count({crease}) == 0);
  CHECK(count({shapes::cube(8)}) == 12 * 8);
  CHECK(count({shapes::cube(8), crease}) > 12 * 8 + 10);
  CHECK(count({shapes::icosphere(6), crease}) == 0);
}

TEST_CASE("feature detection: a crease is followed to where it fades") {
  const surfaces::Surface roof = surfaces::surface("", fadingRoof(40, 80));
  double end = 0;
  const std::vector<Halfedge> edges = detect(roof, 1);
  for (const Halfedge h : edges) {
    const Vec3 &from = roof.positions()[roof.mesh().origin(h)],
               &to = roof.positions()[roof.mesh().tip(h)];
    CHECK(from.y() == 0);
    CHECK(to.y() == 0);
    end = std::max({end, from.x(), to.x()});
  }
  // Sharp to x = 20, faded to a quarter of that bend at x = 35: no gap, no loose piece.
  CHECK(double(edges.size()) == end);
  CHECK(end >= 33);
  CHECK(end <= 36);
}

TEST_CASE("feature detection: the apex of a cone is a tip, and no other vertex of anything is") {
  const auto tips = [](const TriangleMesh& mesh) {
    const surfaces::Surface surface = surfaces::surface("", mesh);
    return detectTips(surface.mesh(), surface.positions(), detect(surface, 0.1));
  };
  const std::vector<Vertex> onCone = tips(shapes::cone(40));
  REQUIRE(onCone.size() == 1);
  CHECK(surfaces::surface("", shapes::cone(40)).positions()[onCone[0]] == Vec3(0, 0, 2));
  for (const TriangleMesh& mesh : {shapes::cube(4), shapes::cylinder(40, 6), shapes::icosphere(1),
                                   shapes::icosphere(6), shapes::torus(30, 20), shapes::grid(6, 6)})
    CHECK(tips(mesh).empty());
}

TEST_CASE("feature detection: a crease that is nowhere sharp is none") {
  CHECK(detect(surfaces::surface("", fadingRoof(40, 38)), 1).empty());
}
