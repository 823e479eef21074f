// SPDX-License-Identifier: MIT
#include "original/surface/accurate_sizes.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "support/parts.h"
#include "support/surfaces.h"

using namespace remesher;

namespace {

// A plate with a hole, its flat sides known and all their borders curves.
OriginalSurface plate(const Vec3& stretch = Vec3::Ones()) {
  BuiltMesh built = buildMesh(shapes::drilledPlate(6, 1));
  for (Vec3& p : built.positions.values()) p = p.cwiseProduct(stretch);
  FlatRegions flats = findFlatRegions(built.mesh, built.positions, 0.2 * stretch.minCoeff());
  CurveRules rules;
  rules.edges = bordersOf(flats, built.mesh);
  rules.size = 0.1;
  FeatureCurves curves(built.mesh, built.positions, rules);
  return OriginalSurface(std::move(built), std::move(curves), std::move(flats));
}

double areaOf(const VertexData<double>& areas) {
  double sum = 0;
  for (const double area : areas.values()) sum += area;
  return sum;
}

}  // namespace

TEST_CASE("refined faces: parts of flat faces are no longer than asked, and make up the surface") {
  const OriginalSurface surface = plate();
  const RefinedFaces faces(surface, 0.3);
  CHECK(areaOf(faces.areas()) == doctest::Approx(surface.area()));
  for (const auto& [a, b] : faces.edges()) {
    const Vec3 &p = faces.positions()[a], &q = faces.positions()[b];
    // The wall of the hole is not flat: there edges inside faces stay.
    const bool isInFlat = p.head<2>().norm() > 0.6 && q.head<2>().norm() > 0.6;
    if (isInFlat) CHECK(distance(p, q) <= 0.3 + 1e-12);
  }
}

TEST_CASE("refined faces: sides a million times as long as wide have a bounded number of parts") {
  const OriginalSurface surface = plate({1e5, 1e-3, 1e-3});
  const RefinedFaces faces(surface, 0.3);
  CHECK(areaOf(faces.areas()) == doctest::Approx(surface.area()));
  CHECK(faces.middles().size() > 1000);
  CHECK(faces.middles().size() < 1'000'000);
}

TEST_CASE("refined faces: what is linear in space is so in between") {
  const OriginalSurface surface = plate();
  const RefinedFaces faces(surface, 0.3);
  const auto at = [](const Vec3& p) { return 1 + 2 * p.x() - 3 * p.y() + 5 * p.z(); };
  VertexData<double> values(faces.positions().size());
  for (Index i = 0; i < values.size(); ++i) values[Vertex(i)] = at(faces.positions()[Vertex(i)]);
  for (Index f = 0; f < surface.mesh().faceCapacity(); ++f)
    for (const Vec3& weights : {Vec3(0.2, 0.3, 0.5), Vec3(0.7, 0.1, 0.2), Vec3(0, 0.4, 0.6)}) {
      const SurfacePoint p{Face(f), weights};
      CHECK(faces.interpolate(p, values) == doctest::Approx(at(surface.position(p))));
    }
}

TEST_CASE("accurate sizes: small around a hole, large far from it, and as many as there are") {
  const OriginalSurface surface = plate();
  const double mean = 0.25;
  const RefinedFaces faces(surface, mean);
  const VertexData<double> sizes = accurateSizes(surface, faces, {mean, 0.5, 0.24});
  double count = 0, atHole = 10, inside = 0;
  for (Index i = 0; i < sizes.size(); ++i) {
    const Vertex v(i);
    count += faces.areas()[v] / (sizes[v] * sizes[v]);
    if (faces.positions()[v].head<2>().norm() < 0.51) atHole = std::min(atHole, sizes[v]);
    if (faces.positions()[v].head<2>().norm() > 1.5) inside = std::max(inside, sizes[v]);
  }
  CHECK(count == doctest::Approx(surface.area() / (mean * mean)));
  CHECK(atHole < 0.6 * mean);
  CHECK(inside > 1.1 * mean);
}

TEST_CASE("accurate sizes: no steeper along an edge than asked") {
  const OriginalSurface surface = plate();
  const RefinedFaces faces(surface, 0.25);
  const VertexData<double> sizes = accurateSizes(surface, faces, {0.25, 1, 0.24});
  // They are scaled at the end.
  for (const auto& [a, b] : faces.edges())
    CHECK(std::abs(sizes[a] - sizes[b]) <=
          0.26 * distance(faces.positions()[a], faces.positions()[b]));
}
