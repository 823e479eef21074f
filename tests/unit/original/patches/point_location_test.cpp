// SPDX-License-Identifier: MIT
#include "original/patches/point_location.h"

#include <doctest/doctest.h>

#include "support/soups.h"
#include "support/surfaces.h"

using namespace remesher;
using surfaces::Surface;

namespace {

PlanarPatch flatPatch(const Surface& surface) {
  DiskGrower grower(surface.mesh(), {});
  grower.add(Face(0));
  for (std::size_t head = 0; head < grower.faces().size(); ++head)
    for (int i = 0; i < 3; ++i) {
      const Face g = grower.neighbor(HalfedgeMesh::halfedge(grower.faces()[head], i));
      if (g) grower.add(g);
    }
  DiskParameterizer parameterizer;
  const DiskPatch* patch = grower.cut();
  return PlanarPatch(*patch, parameterizer.solve(*patch, surface.positions()));
}

}  // namespace

TEST_CASE("point_location: finds every face it holds, and no other") {
  const Surface sphere = surfaces::surface("", shapes::icosphere(5));
  const PlanarPatch patch = flatPatch(sphere);
  std::vector<char> held(sphere.mesh().faceCapacity() + 1000, 0);
  for (std::size_t n = 0; n < patch.faces().size(); ++n) {
    CHECK(patch.find(patch.faces()[n].face) == n);
    held[patch.faces()[n].face] = 1;
  }
  for (Index f = 0; f < held.size(); ++f) CHECK((patch.find(f) != kNoLocal) == bool(held[f]));
}

TEST_CASE("point_location: from any face the walk finds the face under a point") {
  const Surface plane = surfaces::surface("", shapes::grid(12, 9));
  const PlanarPatch patch = flatPatch(plane);
  soups::Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const auto any = [&] { return LocalIndex(double(patch.faces().size()) * random.number()); };
    const LocalIndex face = any();
    const Vec3 raw = random.point() + Vec3::Constant(1e-3);
    const Vec3 weights = raw / raw.sum();
    const PlanarPatch::Location found = patch.locate(patch.image(face, weights), any());
    CHECK(found.face == face);
    CHECK((found.barycentric - weights).norm() < 1e-9);
  }
}

TEST_CASE("point_location: a corner is found exactly, whichever of its faces the walk ends in") {
  const Surface plane = surfaces::surface("", shapes::grid(12, 9));
  const PlanarPatch patch = flatPatch(plane);
  for (std::size_t n = 0; n < patch.faces().size(); ++n)
    for (int i = 0; i < 3; ++i) {
      const Vec2 corner = patch.image(LocalIndex(n), Vec3::Unit(i));
      const PlanarPatch::Location found = patch.locate(corner, 0);
      CHECK(found.barycentric.maxCoeff() == doctest::Approx(1).epsilon(1e-9));
      CHECK((patch.image(found.face, found.barycentric) - corner).norm() < 1e-9);
    }
}

TEST_CASE("point_location: a point outside goes to a face at the rim") {
  const Surface plane = surfaces::surface("", shapes::grid(12, 9));
  const PlanarPatch patch = flatPatch(plane);
  for (int k = 0; k < 100; ++k) {
    for (const double radius : {1.0, 1.0 + 1e-7, 1.3}) {
      const Vec2 point = radius * shapes::onCircle(k, 100).head<2>();
      const PlanarPatch::Location found = patch.locate(point, LocalIndex(k));
      CHECK(found.barycentric.minCoeff() >= 0);
      CHECK(found.barycentric.sum() == doctest::Approx(1));
      // No farther from the point than twice the gap it has to bridge and the rim's sagitta.
      const double gap = (patch.image(found.face, found.barycentric) - point).norm();
      CHECK(gap < 2 * (radius - 1) + 0.05);
    }
  }
}
