// SPDX-License-Identifier: MIT
#include "jobs/parts/part_report.h"

#include <doctest/doctest.h>

#include "support/shapes.h"

using namespace remesher;

namespace {

TriangleMesh shown(const Transform& place) {
  const std::vector<io::Part> parts = {io::Part{"grid", shapes::grid(4, 4), {place}}};
  return gathered(parts, placesOf(parts));
}

}  // namespace

TEST_CASE("part report: a part is measured where it is shown, unless rounding leaves it no shape") {
  const TriangleMesh itself = shown(Transform::Identity());
  Transform wide = Transform::Identity();
  wide.linear().diagonal() = Vec3(1e3, 1, 0.125);
  CHECK(shown(wide).positions.back() == Vec3(4e3, 4, 0));
  Transform flat = Transform::Identity();
  flat.linear().diagonal() = Vec3(1, 0, 1);
  CHECK(shown(flat).positions == itself.positions);
  // Lines, but for what is lost beside the longest axis.
  Transform line = Transform::Identity();
  line.linear().col(0) = Vec3(1e30, 1e30, 1e-6);
  line.linear().col(1) = Vec3(1e6, 1e-6, 1e-45);
  line.linear().col(2) = Vec3(0, 1e-30, 0);
  CHECK(shown(line).positions == itself.positions);
  line.linear().col(0) = Vec3(-1e30, 3e38, 1);
  line.linear().col(1) = Vec3(1e-6, -1, 0);
  line.linear().col(2) = Vec3(0, 1e-30, 1e-30);
  CHECK(shown(line).positions == itself.positions);
  // Axes that point elsewhere, so that none is lost in doubles.
  line.linear().col(0) = Vec3(1e6, 0, -1e30);
  line.linear().col(1) = Vec3(0, 1e12, 0);
  line.linear().col(2) = Vec3(0.5, 1, 1e-6);
  CHECK(shown(line).positions == itself.positions);
}

TEST_CASE("part report: a part alone is as far off with lines or a place of its own as without") {
  const TriangleMesh original = shapes::icosphere(4), result = shapes::icosphere(2);
  TriangleMesh withLine = original;
  // From far away and back, which would be the farthest.
  withLine.positions.push_back(Vec3(9, 9, 9));
  const auto far = Index(withLine.positions.size() - 1);
  withLine.indices.insert(withLine.indices.begin(), {0, far, far});
  Transform moved = Transform::Identity();
  moved.translation() = Vec3(3, -1, 7);
  const FidelityReport expected = measureFidelity(original, result);
  for (const TriangleMesh& mesh : {original, withLine})
    for (const Transform& place : {Transform(Transform::Identity()), moved}) {
      const std::vector<io::Part> before = {{"original", mesh, {place}}},
                                  after = {{"result", result, {place}}};
      const std::vector<PartPlace> places = placesOf(before);
      const FidelityReport own = fidelityOf({before, after, places}, Maximum::Sampled, {});
      CHECK(own.hausdorff == doctest::Approx(expected.hausdorff).epsilon(1e-3));
      CHECK(own.rms == doctest::Approx(expected.rms).epsilon(2e-2));
    }
}
