// SPDX-License-Identifier: MIT
#include "remesh/accuracy/poor_regions.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "base/part_options.h"
#include "remesh/accuracy/two_sided_distance.h"
#include "support/runs.h"

using namespace remesher;

namespace {

// Bumps so steep that the report's rules refuse what lies around their tops.
TriangleMesh steepSphere() {
  TriangleMesh mesh = shapes::icosphere(8);
  for (std::size_t i = 0; i < mesh.positions.size(); i += 37) mesh.positions[i] *= 1.15;
  return mesh;
}

// Pushes every so many vertices most of the way to a neighbour.
void crowd(shapes::TestRun& test) {
  const HalfedgeMesh& mesh = test.mesh.mesh();
  for (Index i = 0; i < mesh.vertexCapacity(); i += 23) {
    const Halfedge h = mesh.outgoing(Vertex(i));
    if (proposeRelocation(test.mesh, test.projector, {h, {0.2, 0.8, 0}}, test.run.scratch.change))
      apply(test.mesh, test.run.scratch.change);
  }
}

double farthest(const Run& run) {
  const TwoSidedDistance distances(run);
  double result = 0;
  for (Index i = 0; i < run.mesh.mesh().faceCapacity(); ++i)
    if (run.mesh.mesh().isAlive(Face(i))) result = std::max(result, distances.of(Face(i)));
  return result;
}

}  // namespace

TEST_CASE("poor regions: no triangle stays below 20°, and the surface stays where it is") {
  shapes::TestRun test(steepSphere());
  PartOptions options;
  options.scheme = Scheme::Rounds;
  test.run.asked.rule = fidelityRule(options);
  crowd(test);
  REQUIRE(shapes::worstAngle(test.mesh) < radians(15));
  const double before = farthest(test.run);
  const std::size_t vertices = test.mesh.mesh().vertexCount();
  mendPoorRegions(test.run);
  CHECK(shapes::worstAngle(test.mesh) >= radians(20));
  CHECK(farthest(test.run) <= before);
  CHECK(test.mesh.mesh().vertexCount() == vertices);
  CHECK(check(test.mesh.mesh()) == "");
  CHECK(test.run.asked.rule.mode == Fidelity::Loose);
}
