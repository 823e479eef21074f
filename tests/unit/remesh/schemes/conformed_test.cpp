// SPDX-License-Identifier: MIT
#include "remesh/schemes/conformed.h"

#include <doctest/doctest.h>

#include <cmath>

#include "measure/hausdorff.h"
#include "measure/mesh_report.h"
#include "measure/self_intersections.h"
#include "remesh/schemes/kept_edges.h"
#include "remesh/schemes/remesh.h"
#include "remesh/schemes/shape_comparison.h"
#include "support/parts.h"
#include "support/shapes.h"

using namespace remesher;

namespace {

RemeshOutcome remeshed(const TriangleMesh& input, Index vertices, Prefer prefer) {
  PartOptions options;
  options.vertices = vertices;
  options.prefer = prefer;
  return remeshSurface(input, options, {});
}

// In percent of the diagonal.
double error(const TriangleMesh& original, const TriangleMesh& result) {
  const DeviationBothWays d = measureDeviation(original, result, Maximum::Sampled);
  return 100 * std::max(d.toResult.maximum, d.toOriginal.maximum) / d.diagonal;
}

// An outline of radii and heights turned about an axis. An end without a radius is on the axis, and
// others are joined to each other.
TriangleMesh turnedAbout(const std::vector<Vec2>& outline, Index sides) {
  TriangleMesh mesh;
  std::vector<std::vector<Index>> rings;
  for (const Vec2& p : outline) {
    std::vector<Index>& ring = rings.emplace_back();
    for (Index i = 0; i < (p.x() == 0 ? 1 : sides); ++i) {
      const Vec3 unit = shapes::onCircle(int(i), int(sides));
      ring.push_back(shapes::addVertex(mesh, {p.x() * unit.x(), p.x() * unit.y(), p.y()}));
    }
  }
  const bool isClosed = rings.front().size() == 1;
  for (std::size_t k = 0; k + isClosed < rings.size(); ++k) {
    const std::vector<Index>&low = rings[k], &high = rings[(k + 1) % rings.size()];
    for (Index i = 0; i < sides; ++i) {
      const auto at = [&](const std::vector<Index>& ring, Index j) {
        return ring[j % ring.size()];
      };
      if (low.size() > 1) shapes::addTriangle(mesh, at(low, i), at(low, i + 1), at(high, i));
      if (high.size() > 1) shapes::addTriangle(mesh, at(low, i + 1), at(high, i + 1), at(high, i));
    }
  }
  return mesh;
}

// Walls of 48 facets, thinner than isotropic triangles are long.
TriangleMesh cup() { return turnedAbout({{0, 0}, {10, 0}, {10, 8}, {9, 8}, {9, 1}, {0, 1}}, 48); }

// A drum whose wall has plane facets up to half its height, and above that rows of triangles, each
// turned by half a side.
TriangleMesh drum(Index sides, Index rows) {
  TriangleMesh mesh;
  const auto at = [&](Index row, Index i) { return row * sides + i % sides; };
  for (Index k = 0; k <= rows + 1; ++k)
    for (Index i = 0; i < sides; ++i) {
      const Index halves = 2 * i + (k > 0 ? k - 1 : 0);
      const double z = k == 0 ? 0 : 4 + 4 * double(k - 1) / double(rows);
      shapes::addVertex(mesh, 4 * shapes::onCircle(int(halves), int(2 * sides)) + Vec3(0, 0, z));
    }
  for (Index k = 0; k <= rows; ++k)
    for (Index i = 0; i < sides; ++i) {
      shapes::addTriangle(mesh, at(k, i), at(k, i + 1), at(k + 1, i));
      shapes::addTriangle(mesh, at(k, i + 1), at(k + 1, i + 1), at(k + 1, i));
    }
  for (Index i = 1; i + 1 < sides; ++i) {
    shapes::addTriangle(mesh, at(0, 0), at(0, i + 1), at(0, i));
    shapes::addTriangle(mesh, at(rows + 1, 0), at(rows + 1, i), at(rows + 1, i + 1));
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

TEST_CASE("conformed: a turned part has its shape at any number, however little of it is flat") {
  const TriangleMesh tube = turnedAbout({{8, 0}, {10, 0}, {10, 40}, {8, 40}}, 24);
  const TriangleMesh shaft = turnedAbout({{0, 0}, {5, 0}, {5, 10}, {8, 10}, {8, 30}, {0, 30}}, 32);
  for (const TriangleMesh& part : {tube, shaft}) {
    const MeshReport own = inspectMesh(part);
    for (const double times : {1.02, 1.1, 2.0, 4.0}) {
      CAPTURE(times);
      const auto vertices = Index(std::lround(times * double(own.vertices)));
      const RemeshOutcome made = remeshed(part, vertices, Prefer::Auto);
      CHECK(inspectMesh(made.mesh).vertices == vertices);
      CHECK(error(part, made.mesh) < 1e-6);
    }
  }
}

TEST_CASE("conformed: isotropic triangles that are taken cut no rim by more than is seen") {
  const TriangleMesh part = turnedAbout({{0, 0}, {9, 0}, {10, 1}, {10, 19}, {9, 20}, {0, 20}}, 60);
  for (const Index vertices : {1600U, 2420U, 3200U}) {
    CAPTURE(vertices);
    CHECK(error(part, remeshed(part, vertices, Prefer::Auto).mesh) < 1.05 * 100 * kSeen);
  }
}

TEST_CASE("conformed: with enough vertices a thin wall of facets has no needle") {
  const RemeshOutcome made = remeshed(cup(), 4 * 194, Prefer::Auto);
  CHECK(inspectMesh(made.mesh).minAngle.mean > 40);
  CHECK(inspectMesh(made.mesh).minAngle.worst > 15);
}

TEST_CASE("conformed: facets that would be poorly shaped are unrolled, and the part is kept") {
  const TriangleMesh flange =
      turnedAbout({{4, 0}, {20, 0}, {20, 5}, {10, 5}, {10, 25}, {4, 25}}, 72);
  const BuiltMesh built = buildMesh(flange);
  const auto ruleAt = [&](Index vertices) {
    return remeshed(flange, vertices, Prefer::Auto).chosen.rule;
  };
  CHECK(ruleAt(2 * 432) == "facets-conforming");  // too few for well-shaped triangles
  const RemeshOutcome made = remeshed(flange, 4 * 432, Prefer::Auto);
  CHECK(made.chosen.rule == "facets-unrolled");
  const MeshReport report = inspectMesh(made.mesh);
  CHECK(report.minAngle.mean > 45);
  CHECK(report.minAngle.worst > 12);
  CHECK(error(flange, made.mesh) < 0.11);
  CHECK(selfIntersections(made.mesh).empty());
  const BuiltMesh result = buildMesh(made.mesh);
  const Surface original{built.mesh, built.positions}, other{result.mesh, result.positions};
  CHECK(shareOfSharpEdges(original, other, 1e-6 * 47) == 1);
  CHECK(std::abs(changeOfVolume(original, other)) < 1e-3);
}

TEST_CASE("conformed: round parts get well-shaped triangles, and nearer ones with more vertices") {
  const TriangleMesh tube = turnedAbout({{8, 0}, {10, 0}, {10, 40}, {8, 40}}, 64);
  const TriangleMesh bolt =
      turnedAbout({{0, 0}, {4, 0}, {5, 1}, {5, 20}, {9, 20}, {9, 25}, {8, 26}, {0, 26}}, 80);
  const struct Case {
    const TriangleMesh& part;
    std::vector<double> times;
  } cases[] = {{tube, {6, 16}}, {bolt, {4, 8}}};
  for (const auto& [part, all] : cases) {
    double before = 0.2;
    for (const double times : all) {
      CAPTURE(times);
      const auto vertices = Index(std::lround(times * double(inspectMesh(part).vertices)));
      const TriangleMesh made = remeshed(part, vertices, Prefer::Auto).mesh;
      const MeshReport report = inspectMesh(made);
      CHECK(report.vertices == vertices);
      CHECK(report.minAngle.mean > 44.5);
      CHECK(report.minAngle.worst > 12);
      const BuiltMesh own = buildMesh(part), other = buildMesh(made);
      const double change =
          changeOfVolume({own.mesh, own.positions}, {other.mesh, other.positions});
      CHECK(std::abs(change) <= 1e-3);
      const double now = error(part, made);
      CHECK(now < 1.1 * before + 0.01);
      before = now;
    }
    CHECK(before < 1.05 * 100 * kSeen);
  }
}

TEST_CASE(
    "conformed: facets whose own angles are nearly good hardly change when they are unrolled") {
  std::vector<Vec2> outline = {{0, 0}, {10, 0}};
  for (int k = 1; k < 8; ++k) outline.push_back(10 * shapes::onCircle(k, 32).head<2>());
  outline.emplace_back(0, 10);
  const TriangleMesh dome = turnedAbout(outline, 32);
  for (const Index times : {4U, 5U}) {
    CAPTURE(times);
    const TriangleMesh made = remeshed(dome, times * 258, Prefer::Auto).mesh;
    CHECK(inspectMesh(made).minAngle.mean > 45);
    CHECK(error(dome, made) < 0.01);
  }
}

TEST_CASE("conformed: where facets have wide angles isotropic triangles are not nearly seen") {
  const TriangleMesh part = drum(48, 5);
  for (const Index times : {8U, 12U}) {
    CAPTURE(times);
    const TriangleMesh made = remeshed(part, times * 336, Prefer::Auto).mesh;
    CHECK(inspectMesh(made).minAngle.mean > 47.5);
    CHECK(error(part, made) < 0.03);
  }
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

TEST_CASE("conformed: a narrow corner, which stays so, is no reason to leave the other facets") {
  // A drop: a round wall between two flat ones that meet at nine degrees.
  constexpr int kSides = 24;
  const double half = radians(4.5), turn = 3 * radians(60) + 2 * half;
  std::vector<Vec2> outline = {{1 / std::sin(half), 0}};
  for (int k = 0; k <= kSides; ++k) {
    const double at = radians(90) - half + turn * k / kSides;
    outline.emplace_back(std::cos(at), std::sin(at));
  }
  const TriangleMesh drop = shapes::extruded(outline, 1);
  for (const Index times : {10, 20}) {
    const RemeshOutcome made = remeshed(drop, times * Index(drop.positions.size()), Prefer::Auto);
    CHECK(error(drop, made.mesh) < 1e-4);
    CHECK(inspectMesh(made.mesh).minAngle.mean > 48);
  }
}

TEST_CASE("conformed: the fewest vertices of a part are the corners of its facets") {
  CHECK(fewestConformed(shapes::cube(3)) == 8);
  const TriangleMesh ring = turnedAbout({{1, 0}, {2, 0}, {2, 1}, {1, 1}}, 24);
  CHECK(fewestConformed(ring) == ring.positions.size());
  CHECK(error(ring, conformed(buildMesh(ring), ring, 96, Textures::Keep)->mesh) < 1e-9);
  CHECK(fewestConformed(shapes::icosphere(4)) == 0);
}

TEST_CASE("conformed: round bodies are not made of facets and are never meshed so") {
  CHECK_FALSE(isFaceted(buildMesh(shapes::icosphere(8))));
  CHECK(isFaceted(buildMesh(cup())));
  CHECK(remeshed(shapes::icosphere(8), 700, Prefer::Auto).chosen.rule != "facets-conforming");
  CHECK(remeshed(cup(), 200, Prefer::Auto).chosen.rule == "facets-conforming");
}
