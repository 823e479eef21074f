// SPDX-License-Identifier: MIT
#include "jobs/part_repair.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "io/formats.h"
#include "jobs/mending.h"
#include "measure/mesh_report.h"
#include "measure/self_intersections.h"
#include "remesher.h"
#include "support/hostile_shapes.h"
#include "support/shapes.h"
#include "support/soups.h"
#include "support/volume_of.h"

using namespace remesher;

namespace {

RemeshOutcome outcomeWith(const TriangleMesh& mesh) {
  RemeshOutcome outcome;
  outcome.mesh = mesh;
  return outcome;
}

// A turned cube.
io::Part turnedCube(double size) {
  TriangleMesh mesh = shapes::cube(12);
  const Eigen::AngleAxisd turn(0.4, Vec3(1, 2, 3).normalized());
  for (Vec3& p : mesh.positions) p = turn * p / 6;
  for (Vec3& p : mesh.positions) p *= size;
  return {"", mesh, {Transform::Identity()}};
}

// A GLB file of two cubes, `by` apart along x, in general position.
FileBundle twoCubes(double by) {
  const TriangleMesh cube = shapes::cube(1);
  io::Model model;
  model.parts = {{"one", cube, {Transform::Identity()}},
                 {"other", soups::moved(cube, {by, 0.2, 0.3}), {Transform::Identity()}}};
  return {io::write(model, "a.glb").files.front(), {}};
}

// Cubes in general position around a middle, all in one, each of a material of its own.
TriangleMesh knotOfCubes(int count) {
  TriangleMesh mesh;
  for (int i = 0; i < count; ++i) {
    const Eigen::AngleAxisd turn(0.7 * i, Vec3(1, 0.3 * i, 2).normalized());
    TriangleMesh cube = shapes::cube(1);
    for (Vec3& p : cube.positions) p = turn * (p + Vec3(0.31, 0.2, 0.13));
    mesh = soups::joined({mesh, cube});
    mesh.groups.resize(mesh.triangleCount(), Index(i));
  }
  return mesh;
}

bool saysThatPartsMeet(const Report& report) {
  return std::any_of(report.warnings.begin(), report.warnings.end(),
                     [](const Warning& warning) { return warning.code == "PARTS_MEET"; });
}

std::size_t trianglesOfFirst(const std::vector<io::Part>& parts, PartOptions options) {
  options.repair = Repair::Wrap;  // by a lattice
  return repairParts(parts, options, {}).parts.front().mesh.triangleCount();
}

}  // namespace

TEST_CASE("part repair: a sound outcome is returned as it is") {
  const TriangleMesh sphere = shapes::icosphere(3);
  RemeshOutcome outcome = outcomeWith(shapes::icosphere(2));
  CHECK(inSoundPrecisionOf(sphere, outcome).mesh.positions == shapes::icosphere(2).positions);
  CHECK(outcome.warnings.empty());
  CHECK(outcome.stopped == Stopped::Target);
}

TEST_CASE("part repair: what rounding makes meet itself becomes the sound original, and says so") {
  TriangleMesh sphere = shapes::icosphere(3);
  sphere.isSingle = true;
  for (Vec3& p : sphere.positions) p = inSingle(p, {});
  // Closer to each other than single precision tells apart.
  const TriangleMesh twice =
      soups::joined({sphere, soups::moved(shapes::turnedOver(sphere), {1e-9, 0, 0})});
  RemeshOutcome outcome = outcomeWith(twice);
  CHECK(inSoundPrecisionOf(sphere, outcome).mesh.positions == sphere.positions);
  CHECK(outcome.stopped == Stopped::Fidelity);
  REQUIRE(outcome.warnings.size() == 1);
  CHECK(outcome.warnings.front().code == "ONLY_REPAIRED");

  // Of two that are broken the result remains.
  RemeshOutcome broken = outcomeWith(twice);
  CHECK(inSoundPrecisionOf(twice, broken).mesh.triangleCount() == twice.triangleCount());
  CHECK(broken.warnings.empty());
}

TEST_CASE("part repair: bodies that touch along an edge do not come out open") {
  TriangleMesh other = soups::moved(soups::cube(0, 1), {1, 1, 0});
  const TriangleMesh touching = soups::joined({soups::cube(0, 1), other});
  RemeshOutcome closed = outcomeWith(touching);
  CHECK(inSoundPrecisionOf(touching, closed).mesh.indices == touching.indices);
  CHECK(closed.warnings.empty());
  other.indices.resize(other.indices.size() - 3);
  RemeshOutcome open = outcomeWith(soups::joined({soups::cube(0, 1), other}));
  CHECK(inSoundPrecisionOf(touching, open).mesh.indices == touching.indices);
  CHECK(open.warnings.front().code == "ONLY_REPAIRED");
}

TEST_CASE("part repair: bodies that come out inside out are turned, and cavities are not") {
  TriangleMesh wall = shapes::turnedOver(shapes::icosphere(2));
  for (Vec3& p : wall.positions) p *= 0.5;
  const TriangleMesh hollow = soups::joined({shapes::icosphere(2), wall});
  const TriangleMesh thin = shapes::turnedOver(soups::moved(shapes::tetrahedron(), {5, 0, 0}));
  RemeshOutcome outcome = outcomeWith(soups::joined({hollow, thin}));
  const TriangleMesh made = inSoundPrecisionOf(shapes::icosphere(3), outcome).mesh;
  CHECK(shapes::volumeOf(made) ==
        doctest::Approx(shapes::volumeOf(hollow) + shapes::volumeOf(shapes::tetrahedron())));
  CHECK(outcome.warnings.empty());
}

TEST_CASE("part repair: a part has the lattice of the scene, and a part alone its own") {
  PartOptions options;
  options.vertices = 8400;
  const auto trianglesOf = [&](const std::vector<io::Part>& parts) {
    return trianglesOfFirst(parts, options);
  };
  const std::size_t alone = trianglesOf({turnedCube(1)});
  CHECK(trianglesOf({turnedCube(128)}) == alone);
  const std::size_t beside = trianglesOf({turnedCube(1), turnedCube(128)});
  // The coarsest spacing there is instead of one for that number.
  CHECK(double(beside) < 0.75 * double(alone));
  CHECK(double(beside) > 0.5 * double(alone));
  io::Part large = turnedCube(1);
  large.instances.front().linear() *= 128;
  CHECK(trianglesOf({large, turnedCube(128)}) == trianglesOf({turnedCube(128), large}));
}

TEST_CASE("part repair: an edge length is one of the world, in any unit") {
  PartOptions options;
  options.edgeLength = 0.05;
  const std::size_t wanted = trianglesOfFirst({turnedCube(1)}, options);
  options.edgeLength = 0.064;
  CHECK(double(trianglesOfFirst({turnedCube(1)}, options)) < 0.75 * double(wanted));
  options.edgeLength = 0.05;
  io::Part placed = turnedCube(std::ldexp(1.0, 5));
  placed.instances.front().linear() *= std::ldexp(1.0, -5);
  CHECK(trianglesOfFirst({placed}, options) == wanted);
  options.edgeLength = std::ldexp(0.05, -60);
  CHECK(trianglesOfFirst({turnedCube(std::ldexp(1.0, -60))}, options) == wanted);
}

TEST_CASE("part repair: a thickness that rounding makes is joined before repair, not after it") {
  TriangleMesh flat = shapes::icosphere(2);
  flat.isSingle = true;
  for (Vec3& p : flat.positions) p = inSingle({1e-8 * p.x(), p.y(), p.z()}, {});
  PartOptions options;
  options.repair = Repair::Wrap;
  std::vector<io::Part> parts = {{"", flat, {}}};
  repairOnly(parts, Held::Apart, IfSound::IsRounded, options, {});
  CHECK(inspectMesh(parts.front().mesh).nonManifoldEdges == 0);
  CHECK(selfIntersections(parts.front().mesh).empty());
}

TEST_CASE("part repair: a part thinner than the frame's roundings intersects as it is given") {
  for (const double thin : {1e-7, 1e-15, 1e-17}) {
    TriangleMesh mesh = shapes::icosphere(6);
    for (Vec3& p : mesh.positions) p = Vec3(1e-7 * p.x(), p.y() + 0.3, thin * p.z());
    const FaultReport faults = faultsOf(std::vector<io::Part>{{"", mesh, {Transform::Identity()}}});
    CHECK(faults.selfIntersections == selfIntersections(mesh).size());
  }
}

TEST_CASE("part repair: parts that meet stay parts, which is said; in one solid they are united") {
  PartOptions options;
  options.repair = Repair::Auto;
  const auto repaired = [&](double by, const char* output) {
    return repairFile(twoCubes(by), output, options).report;
  };
  const Report parts = repaired(0.5, "a.glb"), united = repaired(0.5, "a.ply");
  CHECK(parts.output->components == 2);
  CHECK(saysThatPartsMeet(parts));
  CHECK_FALSE(saysThatPartsMeet(repaired(5, "a.glb")));
  CHECK(saysThatPartsMeet(inspectFileClosely(twoCubes(0.5)).report));
  CHECK_FALSE(saysThatPartsMeet(inspectFileClosely(twoCubes(5)).report));
  CHECK(united.output->components == 1);
  CHECK_FALSE(saysThatPartsMeet(united));
  options.vertices = 400;
  const Report report = remeshFile(twoCubes(0.5), "a.stl", options).report;
  CHECK(report.output->components == 1);
  CHECK(report.output->vertices == 400);
  options.repair = Repair::Off;
  CHECK(remeshFile(twoCubes(0.5), "a.stl", options).report.output->components == 2);
}

TEST_CASE("part repair: bodies with more corners than vertices asked for get that number") {
  PartOptions options;
  options.repair = Repair::Solid;
  for (const Index vertices : {60, 120, 240}) {
    options.vertices = vertices;
    const RemeshResult result = remesh(knotOfCubes(24), options);
    CHECK(inspectMesh(result.mesh).vertices == vertices);
    CHECK(isSound(result.mesh));
    CHECK(result.report.stopped == Stopped::Target);
  }
}

TEST_CASE("part repair: a shape that is preferred is one of the repaired surface, and sound") {
  PartOptions options;
  options.repair = Repair::Solid;
  options.prefer = Prefer::Shape;
  options.vertices = 40;
  const RemeshResult united = remesh(turnedCube(1).mesh, options);
  CHECK(united.report.prefer == std::vector{Prefer::Shape});
  CHECK(inspectMesh(united.mesh).vertices == 40);
  CHECK(isSound(united.mesh));
  CHECK(united.report.fidelity->hausdorff < 0.1);

  // Of a thin shell its own vertices would pass through those of the other side.
  TriangleMesh inner = shapes::turnedOver(shapes::icosphere(16));
  for (Vec3& p : inner.positions) p *= 0.985;
  options.repair = Repair::Holes;
  options.vertices = 60;
  const RemeshResult shell = remesh(soups::joined({shapes::icosphere(16), inner}), options);
  CHECK(shell.report.prefer == std::vector{Prefer::Even});
  CHECK(isSound(shell.mesh));
}

TEST_CASE("part repair: coordinates that nothing changed are exactly those of the file") {
  // Numbers that differ in their last digit, which a frame may round to one.
  TriangleMesh ring = shapes::torus(24, 12);
  ring = soups::joined({ring, soups::moved(ring, {8.6, 0, 0})});
  for (std::size_t v = 0; v < ring.positions.size(); v += 2)
    for (double& x : ring.positions[v]) x = std::nextafter(x, 100);
  TriangleMesh torn = ring;
  torn.indices.resize(torn.indices.size() - 6);
  PartOptions options;
  options.repair = Repair::Auto;
  const auto repairedPart = [&](const TriangleMesh& mesh) {
    return repairParts({{"", mesh, {Transform::Identity()}}}, options, {}).parts.front().mesh;
  };
  CHECK(repairedPart(ring).positions == ring.positions);
  const TriangleMesh closed = repairedPart(torn);
  REQUIRE(closed.indices.size() >= torn.indices.size());
  for (std::size_t i = 0; i < torn.indices.size(); ++i) {
    const Vec3& p = closed.positions[closed.indices[i]];
    CHECK(std::any_of(torn.positions.begin(), torn.positions.end(),
                      [&](const Vec3& q) { return q == p; }));
  }
}

TEST_CASE(
    "part repair: a surface that is sound once its places are joined is not called unchanged") {
  PartOptions options;
  options.repair = Repair::Auto;
  const auto countRounded = [](const std::vector<Warning>& warnings) {
    std::size_t count = 0;
    for (const Warning& warning : warnings)
      if (warning.code == "PLACES_JOINED") count += warning.count;
    return count;
  };
  TriangleMesh mesh = soups::cube(0, 1);
  CHECK(repair(mesh, options).report.repair->reason == "sound");
  CHECK(countRounded(inspectClosely(mesh).report.warnings) == 0);
  mesh.isSingle = true;
  for (Index v = 0; v < 12; ++v) mesh.positions[v].x() += 0x1p-28;  // some corners of a full turn
  const RepairResult joined = repair(mesh, options);
  CHECK(joined.report.repair->reason == "joined");
  const std::size_t count = countRounded(inspectClosely(mesh).report.warnings);
  CHECK(count > 0);
  CHECK(countRounded(joined.report.warnings) == count);
  CHECK(countRounded(inspectClosely(joined.mesh).report.warnings) == 0);
  REQUIRE(joined.report.chosen.size() == 1);
  CHECK(joined.report.chosen.front().rule == "repaired");
}
