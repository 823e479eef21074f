// SPDX-License-Identifier: MIT
#include "remesh/schemes/conformed.h"

#include <doctest/doctest.h>

#include <cmath>

#include "measure/hausdorff.h"
#include "measure/mesh_report.h"
#include "measure/self_intersections.h"
#include "remesh/schemes/remesh.h"
#include "remesh/schemes/shape_comparison.h"
#include "support/parts.h"
#include "support/shapes.h"

using namespace remesher;

namespace {

RemeshOutcome remeshed(const TriangleMesh& input, Index vertices, Prefer prefer) {
  RemeshOptions options;
  options.vertices = vertices;
  options.prefer = prefer;
  return remeshSurface(input, options, {});
}

// In percent of the diagonal.
double error(const TriangleMesh& original, const TriangleMesh& result) {
  const DeviationBothWays d = measureDeviation(original, result, Maximum::Sampled);
  return 100 * std::max(d.toResult.maximum, d.toOriginal.maximum) / d.diagonal;
}

// A cup turned about its axis: walls of 48 facets, thinner than isotropic triangles are long.
TriangleMesh cup() {
  const std::vector<Vec2> profile = {{10, 0}, {10, 8}, {9, 8}, {9, 1}};  // radius, height
  constexpr Index kSides = 48;
  TriangleMesh mesh;
  const auto onRim = [](const Vec2& p, Index i) {
    const Vec3 unit = shapes::onCircle(int(i), int(kSides));
    return Vec3(p.x() * unit.x(), p.x() * unit.y(), p.y());
  };
  for (const Vec2& p : profile)
    for (Index i = 0; i < kSides; ++i) shapes::addVertex(mesh, onRim(p, i));
  const Index bottom = Index(mesh.positions.size()), inside = bottom + 1;
  shapes::addVertex(mesh, {0, 0, 0});
  shapes::addVertex(mesh, {0, 0, 1});
  for (Index i = 0; i < kSides; ++i) {
    const Index next = (i + 1) % kSides;
    shapes::addTriangle(mesh, bottom, next, i);
    shapes::addTriangle(mesh, inside, 3 * kSides + i, 3 * kSides + next);
    for (Index row = 0; row < 3 * kSides; row += kSides) {
      shapes::addTriangle(mesh, row + i, row + next, row + kSides + next);
      shapes::addTriangle(mesh, row + i, row + kSides + next, row + kSides + i);
    }
  }
  return mesh;
}

}  // namespace

TEST_CASE("conformed: a part with more vertices than its own never has less of its shape") {
  for (const TriangleMesh& part : {cup(), shapes::filletedBar(6), shapes::drilledPlate(8, 0.5)}) {
    const MeshReport own = inspectMesh(part);
    for (const double times : {1.0, 1.02, 1.3, 4.0, 10.0}) {
      CAPTURE(times);
      const auto vertices = Index(std::lround(times * double(own.vertices)));
      const RemeshOutcome made = remeshed(part, vertices, Prefer::Auto);
      const MeshReport report = inspectMesh(made.mesh);
      CHECK(report.vertices == vertices);
      CHECK(report.eulerCharacteristic == own.eulerCharacteristic);
      CHECK(error(part, made.mesh) < 1e-6);
      CHECK(selfIntersections(made.mesh).empty());
      CHECK(report.minAngle.mean > own.minAngle.mean - 1);
    }
  }
}

TEST_CASE("conformed: with enough vertices a thin wall of facets has no needle") {
  const RemeshOutcome made = remeshed(cup(), 4 * 194, Prefer::Auto);
  CHECK(inspectMesh(made.mesh).minAngle.mean > 40);
  CHECK(inspectMesh(made.mesh).minAngle.worst > 15);
}

TEST_CASE("conformed: with shape preferred a part has no needle at many vertices") {
  const TriangleMesh bar = shapes::filletedBar(6);
  const RemeshOutcome made = remeshed(bar, Index(12 * inspectMesh(bar).vertices), Prefer::Shape);
  CHECK(made.prefer == Prefer::Shape);
  CHECK(inspectMesh(made.mesh).minAngle.worst > 10);
  CHECK(error(bar, made.mesh) < 1e-6);
}

TEST_CASE("conformed: triangles keep their group, and shading goes over them as before") {
  TriangleMesh part = shapes::drilledPlate(8, 0.5);
  Attribute normals{"NORMAL", 3, {}};
  for (const Vec3& p : part.positions) {
    const Vec3 n = Vec3(p.x(), p.y(), 0).normalized();
    normals.values.insert(normals.values.end(), {float(n.x()), float(n.y()), float(n.z())});
  }
  part.attributes.push_back(normals);
  for (Index t = 0; t < part.triangleCount(); ++t) {
    double height = 0;
    for (Index k = 0; k < 3; ++k) height += part.positions[part.indices[3 * t + k]].z();
    part.groups.push_back(height == 0 ? 1 : 0);
  }
  const std::optional<Followed> made = conformed(buildMesh(part), part, 200, Textures::Keep);
  REQUIRE(made);
  CHECK(made->places.size() == made->mesh.indices.size());
  CHECK(made->mesh.groups.size() == made->mesh.triangleCount());
  for (Index t = 0; t < made->mesh.triangleCount(); ++t) {
    double height = 0;
    for (Index k = 0; k < 3; ++k) height += made->mesh.positions[made->mesh.indices[3 * t + k]].z();
    CHECK(made->mesh.groups[t] == (height == 0 ? 1 : 0));
  }
  for (std::size_t i = 0; i < made->mesh.attributes[0].values.size(); i += 3) {
    const float* const n = &made->mesh.attributes[0].values[i];
    CHECK(std::hypot(n[0], n[1], n[2]) == doctest::Approx(1).epsilon(1e-5));
  }
}

TEST_CASE("conformed: round bodies are not made of facets and are never meshed so") {
  CHECK_FALSE(isFaceted(buildMesh(shapes::icosphere(8))));
  CHECK(isFaceted(buildMesh(cup())));
  CHECK(remeshed(shapes::icosphere(8), 700, Prefer::Auto).chosen.rule != "facets-conforming");
  CHECK(remeshed(cup(), 200, Prefer::Auto).chosen.rule == "facets-conforming");
}
