// SPDX-License-Identifier: MIT
#include "jobs/part_repair.h"

#include <doctest/doctest.h>

#include "support/hostile_shapes.h"
#include "support/shapes.h"
#include "support/soups.h"

using namespace remesher;

namespace {

RemeshOutcome outcomeWith(const TriangleMesh& mesh) {
  RemeshOutcome outcome;
  outcome.mesh = mesh;
  return outcome;
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
  for (Vec3& p : sphere.positions) p = inSingle(p, 1);
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

TEST_CASE("part repair: a part has the lattice of the scene, and a part alone its own") {
  // A cube is repaired by a lattice if it crosses another.
  const auto crossed = [](double size) {
    const TriangleMesh cube = shapes::cube(2);
    TriangleMesh mesh = soups::joined({cube, soups::moved(cube, {0.31, 0.42, 0.53})});
    for (Vec3& p : mesh.positions) p *= size;
    return io::Part{"", mesh, {Transform::Identity()}};
  };
  RemeshOptions options;
  options.repair = Repair::Solid;
  options.vertices = 20000;  // nothing is left out afterwards
  const auto trianglesOf = [&](const std::vector<io::Part>& parts) {
    return repairParts(parts, options, {}).parts.front().mesh.triangleCount();
  };
  const std::size_t alone = trianglesOf({crossed(1)});
  CHECK(trianglesOf({crossed(100)}) == alone);
  const std::size_t beside = trianglesOf({crossed(1), crossed(100)});
  // Spacings of 1/128 of its diagonal instead of 1/161.
  CHECK(double(beside) < 0.75 * double(alone));
  CHECK(double(beside) > 0.5 * double(alone));
  io::Part large = crossed(1);
  large.instances.front().linear() *= 100;
  CHECK(trianglesOf({large, crossed(100)}) == trianglesOf({crossed(100), large}));
}
