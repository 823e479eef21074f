// SPDX-License-Identifier: MIT
// What whole runs promise about flat sides: they stay flat, to the last digit; corners of curves.
#include "remesh/schemes/curve_choice.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "measure/hausdorff.h"
#include "remesh/schemes/remesh.h"
#include "support/parts.h"

using namespace remesher;

namespace {

TriangleMesh remeshed(const TriangleMesh& input, Index vertices, Quality quality) {
  PartOptions options;
  options.vertices = vertices;
  options.quality = quality;
  const RemeshOutcome outcome = remeshSurface(input, options, {});
  CHECK(outcome.vertices == vertices);
  return outcome.mesh;
}

double lowest(const TriangleMesh& mesh) {
  double least = 0;
  for (const Vec3& p : mesh.positions) least = std::min(least, p.z());
  return least;
}

// The top of a bar drops by a narrow slope.
TriangleMesh barWithSlope() {
  constexpr double kWidth = 4, kHeight = 1, kStep = 0.07;
  const std::vector<Vec2> outline = {{0, 0},
                                     {kWidth, 0},
                                     {kWidth, kHeight},
                                     {kWidth / 2 + kStep, kHeight},
                                     {kWidth / 2, kHeight + kStep},
                                     {0, kHeight + kStep}};
  return shapes::extruded(outline, shapes::kBarLength);
}

}  // namespace

TEST_CASE("flat sides: a bottom that runs into fillets has no dent at any number of vertices") {
  const TriangleMesh bar = shapes::filletedBar(6);
  const double bottom = shapes::kBarLength * (shapes::kBarWidth - 2 * shapes::kFilletRadius);
  for (const Quality quality : {Quality::Draft, Quality::Best})
    for (const Index vertices : {200, 600, 2000}) {
      CAPTURE(vertices);
      const TriangleMesh result = remeshed(bar, vertices, quality);
      CHECK(shapes::areaAt(result, 0) == doctest::Approx(bottom));
      CHECK(lowest(result) == 0);
    }
}

TEST_CASE("flat sides: sides of quads run along a bottom's rims, where these bend enough") {
  const double bottom = shapes::kBarLength * (shapes::kBarWidth - 2 * shapes::kFilletRadius);
  PartOptions options;
  options.quads = true;
  const auto flatShare = [&](int steps, Index vertices) {
    options.vertices = vertices;
    const TriangleMesh bar = shapes::filletedBar(steps);
    return shapes::areaAt(remeshSurface(bar, options, {}).mesh, 0) / bottom;
  };
  for (const Index vertices : {600, 1000}) {
    CAPTURE(vertices);
    CHECK(flatShare(5, vertices) == doctest::Approx(1));
    CHECK(flatShare(30, vertices) < 0.999);
  }
}

TEST_CASE("curves: quads follow both edges of a slope a fifth of a side wide") {
  const TriangleMesh bar = barWithSlope();
  PartOptions options;
  options.quads = true;
  for (const Index vertices : {400, 600, 900}) {
    CAPTURE(vertices);
    options.vertices = vertices;
    const TriangleMesh quads = remeshSurface(bar, options, {}).mesh;
    CHECK(measureFidelity(bar, quads).hausdorff < 0.01);
  }
}

TEST_CASE("curves: near edges stay for quads where flat sides have too many corners") {
  const BuiltMesh built = buildMesh(barWithSlope());
  PartOptions options;
  options.quads = true;
  for (const Flats flats : {Flats::Bordered, Flats::Unknown}) {
    const CurveChoice choice = chooseCurves(built, {}, options, {0.5, {}, {}, flats});
    for (Index i = 0; i < built.mesh.halfedgeCapacity(); ++i)
      if (borderAlong(built.mesh, built.positions, Halfedge(i)).meanBend() > 0.1)
        CHECK(choice.curves.isCurve(Halfedge(i)));
  }
}

TEST_CASE("flat sides: those of a drilled plate stay in their planes, and the hole is round") {
  const TriangleMesh plate = shapes::drilledPlate(6, 0.5);
  for (const Index vertices : {600, 2500}) {
    CAPTURE(vertices);
    const TriangleMesh result = remeshed(plate, vertices, Quality::Best);
    for (const Vec3& p : result.positions)
      CHECK((p.z() == 0 || p.z() == 0.5 || std::abs(std::abs(p.x()) - 2) < 1e-12 ||
             std::abs(std::abs(p.y()) - 2) < 1e-12 || p.head<2>().norm() < 0.55));
    CHECK(measureFidelity(plate, result).hausdorff < 0.5);
  }
}

TEST_CASE("flat sides: a triangle without area on an edge of a box does no harm") {
  TriangleMesh box = shapes::cube(1);
  const Index a = box.indices[0], b = box.indices[1], c = box.indices[2];
  const Index middle = shapes::addVertex(box, 0.5 * (box.positions[a] + box.positions[b]));
  box.indices[1] = middle;
  shapes::addTriangle(box, middle, b, c);
  shapes::addTriangle(box, a, b, middle);
  for (const Index vertices : {30, 500})
    CHECK(measureFidelity(box, remeshed(box, vertices, Quality::Best)).hausdorff < 1e-6);
}

TEST_CASE("curves: a border ends at a plane that mirrors a half, however little it bends there") {
  const double slight = 0.05;
  TriangleMesh half;
  half.positions = {{0, 0, 0}, {1, 0, 0}, {2, slight, 0}, {2, 1, 0}, {0, 1, 0}};
  half.indices = {0, 1, 4, 1, 2, 3, 1, 3, 4};
  const BuiltMesh built = buildMesh(half);
  PartOptions options;
  for (const bool isMirrored : {false, true}) {
    if (isMirrored) options.mirrors.planes = {{Vec3::UnitY(), 0}};
    const FeatureCurves curves = chooseCurves(built, half, options, {0.1, {}, {}}).curves;
    int count = 0;
    for (Index i = 0; i < built.mesh.vertexCapacity(); ++i)
      count += curves.isCorner(Vertex(i)) && built.positions[Vertex(i)] == half.positions[1];
    CHECK(count == int(isMirrored));
  }
}
