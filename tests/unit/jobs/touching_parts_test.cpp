// SPDX-License-Identifier: MIT
#include "jobs/touching_parts.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <set>
#include <string>

#include "base/place.h"
#include "measure/mesh_report.h"
#include "remesher.h"
#include "support/touching_bodies.h"
#include "support/volume_of.h"

using namespace remesher;

namespace {

using Place3 = std::array<double, 3>;
using CommonCorners = std::array<Place3, 3>;  // the least first

std::vector<TriangleMesh> bodiesByGroup(const TriangleMesh& mesh) {
  std::vector<TriangleMesh> bodies(groupCount(mesh));
  for (TriangleMesh& body : bodies) body.positions = mesh.positions;
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      bodies[mesh.groups[t]].indices.push_back(mesh.indices[3 * t + k]);
  return bodies;
}

enum class Side { Own, Turned };

std::multiset<CommonCorners> trianglesOf(const TriangleMesh& body, Side side) {
  std::multiset<CommonCorners> all;
  for (std::size_t t = 0; t < body.triangleCount(); ++t) {
    CommonCorners corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 p = canonicalPlace(body.positions[body.indices[3 * t + k]]);
      corners[k] = {p.x(), p.y(), p.z()};
    }
    if (side == Side::Turned) std::swap(corners[1], corners[2]);
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    all.insert(corners);
  }
  return all;
}

std::size_t countCommon(const TriangleMesh& one, const TriangleMesh& other) {
  const std::multiset<CommonCorners> own = trianglesOf(one, Side::Own);
  const std::multiset<CommonCorners> its = trianglesOf(other, Side::Turned);
  std::vector<CommonCorners> common;
  std::set_intersection(own.begin(), own.end(), its.begin(), its.end(), std::back_inserter(common));
  return common.size();
}

bool says(const Report& report, const std::string& code) {
  return std::any_of(report.warnings.begin(), report.warnings.end(),
                     [&](const Warning& w) { return w.code == code; });
}

PartOptions conforming(Index vertices) {
  PartOptions options;
  options.conform = true;
  options.vertices = vertices;
  options.quality = Quality::Draft;
  return options;
}

// Whether all bodies are closed by themselves, have their volumes and meet nowhere else.
void checkBodies(const TriangleMesh& given, const RemeshResult& made) {
  const std::vector<TriangleMesh> before = bodiesByGroup(given), after = bodiesByGroup(made.mesh);
  REQUIRE(after.size() == before.size());
  std::size_t common = 0;
  for (std::size_t i = 0; i < after.size(); ++i) {
    const MeshReport report = inspectMesh(after[i]);
    CHECK(report.boundaryEdges == 0);
    CHECK(report.nonManifoldEdges == 0);
    CHECK(shapes::volumeOf(after[i]) == doctest::Approx(shapes::volumeOf(before[i])).epsilon(1e-3));
    for (std::size_t k = 0; k < i; ++k) common += countCommon(after[i], after[k]);
  }
  CHECK(!says(made.report, "SELF_INTERSECTIONS_MADE"));
  REQUIRE(made.report.conform);
  CHECK(made.report.conform->triangles == common);
  CHECK(made.report.output->nonManifoldEdges == 0);
  CHECK(made.report.output->boundaryEdges == 0);
  CHECK(made.report.output->components == after.size());
}

}  // namespace

TEST_CASE("conform: bodies share the triangles of their common faces, at the number of vertices") {
  struct Case {
    TriangleMesh mesh;
    std::size_t faces;
    double area;
  };
  for (const Case& c :
       {Case{shapes::twoBoxes(), 1, 1}, Case{shapes::boxOnPlate(), 1, 1.1},
        Case{shapes::threeLayers(), 2, 8}, Case{shapes::boxesInAnL(), 1, 0.8},
        Case{shapes::shaftInBore(), 1, 2.8194}, Case{shapes::eightCubes(), 12, 12}}) {
    const RemeshResult made = remesh(c.mesh, conforming(900));
    checkBodies(c.mesh, made);
    CHECK(made.report.output->vertices == 900);
    CHECK(countPlaces(made.mesh.positions) == 900);
    CHECK(made.report.conform->faces == c.faces);
    CHECK(made.report.conform->area == doctest::Approx(c.area).epsilon(1e-3));
  }
}

TEST_CASE("conform: a smallest angle leads to a number, and to edges between faces that suit it") {
  for (const TriangleMesh& mesh : {shapes::twoBoxes(), shapes::boxOnPlate()}) {
    PartOptions options;
    options.conform = true;
    options.minAngle = 20;
    const RemeshResult made = remesh(mesh, options);
    checkBodies(mesh, made);
    CHECK(made.report.output->minAngle.worst >= 20);
    CHECK(says(made.report, "MORE_VERTICES_TAKEN"));
  }
}

TEST_CASE("conform: with a mean length longer than facets are wide, angles and shape are kept") {
  PartOptions options;
  options.conform = true;
  options.minAngle = 20;
  options.edgeLength = 1;
  const TriangleMesh mesh = shapes::shaftInBore();
  const RemeshResult made = remesh(mesh, options);
  checkBodies(mesh, made);
  CHECK(made.report.output->minAngle.worst >= 20);
  CHECK(made.report.fidelity->hausdorff < 0.01);
}

TEST_CASE("conform: bodies that touch along a whole edge as well have its vertices in common") {
  const TriangleMesh mesh =
      shapes::together({shapes::box({0, 0, 0}, {4, 4, 4}), shapes::box({4, 0, 0}, {8, 4, 4}),
                        shapes::box({0, 4, 4}, {4, 8, 8})});
  PartOptions options;
  options.conform = true;
  options.edgeLength = 1;
  options.maxEdge = 2;
  options.minAngle = 20;
  const RemeshResult made = remesh(mesh, options);
  CHECK(made.report.output->wanted->maxEdge->missed == 0);
  CHECK(!says(made.report, "VERTICES_COINCIDE"));
}

TEST_CASE("conform: borders of common faces stay, however few vertices are asked for") {
  for (const TriangleMesh& mesh : {shapes::shaftInBore(), shapes::eightCubes()}) {
    const RemeshResult made = remesh(mesh, conforming(90));
    CHECK(made.report.output->vertices == 90);
    CHECK(made.report.output->boundaryEdges == 0);
    for (const TriangleMesh& body : bodiesByGroup(made.mesh))
      CHECK(inspectMesh(body).boundaryEdges == 0);
    CHECK(made.report.conform->area > 2.7);
  }
  CHECK_THROWS_AS(remesh(shapes::shaftInBore(), conforming(30)), Error);
}

TEST_CASE("conform: a ball shares its whole surface with the cavity that it fills") {
  const TriangleMesh mesh = shapes::ballInShell();
  const RemeshResult made = remesh(mesh, conforming(800));
  const std::vector<TriangleMesh> bodies = bodiesByGroup(made.mesh);
  CHECK(countCommon(bodies[0], bodies[1]) == bodies[0].triangleCount());
  CHECK(made.report.conform->faces == 1);
  CHECK(made.report.conform->triangles == bodies[0].triangleCount());
  CHECK(made.report.output->boundaryEdges == 0);
  CHECK(made.report.output->vertices == 800);
  CHECK(!says(made.report, "INCONSISTENT_ORIENTATION_FIXED"));
}

TEST_CASE("conform: limits of every edge hold on common faces") {
  PartOptions options;
  options.conform = true;
  options.maxEdge = 0.25;
  options.minAngle = 20;
  options.quality = Quality::Draft;
  const TriangleMesh mesh = shapes::boxOnPlate();
  const RemeshResult made = remesh(mesh, options);
  checkBodies(mesh, made);
  CHECK(made.report.output->wanted->maxEdge->missed == 0);
  CHECK(made.report.output->wanted->minAngle->kept > 99);
}

TEST_CASE("conform: meshes of a scene keep their own triangles, spaces and attributes") {
  const TriangleMesh mesh = shapes::boxOnPlate();
  std::vector<PlacedMesh> scene;
  const Transform place(Eigen::Translation3d(1, 2, 3));
  for (const TriangleMesh& body : bodiesByGroup(mesh)) {
    scene.push_back({body, {place}});
    Attribute height{"_HEIGHT", 1, {}};
    for (const Vec3& p : body.positions) height.values.push_back(float(p.z()));
    scene.back().mesh.attributes.push_back(height);
  }
  scene.push_back({shapes::box({9, 0, 0}, {10, 1, 1}), {place}});
  const RemeshSceneResult made = remeshScene(scene, conforming(1200));
  REQUIRE(made.meshes.size() == 3);
  CHECK(countCommon(made.meshes[0], made.meshes[1]) == made.report.conform->triangles);
  CHECK(made.report.conform->triangles > 10);
  CHECK(made.report.output->vertices == 1200);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(inspectMesh(made.meshes[i]).boundaryEdges == 0);
    if (i == 2) continue;
    const Attribute* const height = findAttribute(made.meshes[i], "_HEIGHT");
    REQUIRE(height);
    for (std::size_t v = 0; v < made.meshes[i].positions.size(); ++v)
      CHECK(height->values[v] == doctest::Approx(made.meshes[i].positions[v].z()).epsilon(1e-3));
  }
}

TEST_CASE("conform: bodies that do not touch are remeshed as without, and gaps are said") {
  for (const double gap : {0.3, 0.004}) {
    const TriangleMesh mesh = shapes::twoBoxes(gap);
    PartOptions options = conforming(300);
    const RemeshResult with = remesh(mesh, options);
    options.conform = false;
    const RemeshResult without = remesh(mesh, options);
    CHECK(with.mesh.positions == without.mesh.positions);
    CHECK(with.mesh.indices == without.mesh.indices);
    CHECK(says(with.report, "NO_BODIES_TOUCH"));
    CHECK(says(with.report, "BODIES_ALMOST_TOUCH") == (gap < 0.01));
    CHECK(!with.report.conform);
  }
}

TEST_CASE("conform: meshes shown at several places are left alone, which is said") {
  const auto moved = [](double x) { return Transform(Eigen::Translation3d(x, 0, 0)); };
  std::vector<PlacedMesh> scene(2);
  scene[0].mesh = shapes::box({0, 0, 0}, {1, 1, 1});
  scene[0].places = {moved(0), moved(3)};
  scene[1].mesh = shapes::box({1, 0, 0}, {2, 1, 1});
  scene[1].places = {moved(0)};
  const RemeshSceneResult made = remeshScene(scene, conforming(300));
  CHECK(says(made.report, "INSTANCES_NOT_CONFORMED"));
  CHECK(!made.report.conform);
}

TEST_CASE("conform: overlaps beside common faces are said, with a place") {
  const TriangleMesh mesh =
      shapes::together({shapes::box({0, 0, 0}, {2, 1, 1}), shapes::box({0, 0, 1}, {1, 1, 2}),
                        shapes::box({1.6, 0.2, 0.4}, {2.5, 0.7, 1.3})});
  const RemeshResult made = remesh(mesh, conforming(500));
  const auto found = std::find_if(made.report.warnings.begin(), made.report.warnings.end(),
                                  [](const Warning& w) { return w.code == "BODIES_OVERLAP"; });
  REQUIRE(found != made.report.warnings.end());
  REQUIRE(found->at);
  CHECK(found->at->x() > 1);
}

TEST_CASE("conform: what it cannot keep is refused") {
  const std::vector<std::function<void(PartOptions&)>> others = {
      [](PartOptions& o) { o.quads = true; },
      [](PartOptions& o) { o.repair = Repair::Auto; },
      [](PartOptions& o) { o.prefer = Prefer::Shape; },
      [](PartOptions& o) { o.boundary = Boundary::Keep; },
      [](PartOptions& o) { o.lods = {0.5}; },
      [](PartOptions& o) { o.region = {0}; }};
  for (const auto& set : others) {
    PartOptions options = conforming(300);
    set(options);
    CHECK_THROWS_AS(remesh(shapes::twoBoxes(), options), Error);
  }
}

TEST_CASE("conform: without it bodies that touch are united, and a smallest angle is kept, too") {
  PartOptions options;
  options.minAngle = 20;
  options.repair = Repair::Auto;
  const TriangleMesh mesh = shapes::together(
      {shapes::box({0, 0, 0}, {80, 50, 5}), shapes::box({10, -10, 5}, {60, 30, 9})});
  const RemeshResult made = remesh(mesh, options);
  REQUIRE(made.report.output->components == 1);
  CHECK(made.report.output->minAngle.worst >= 20);
}
