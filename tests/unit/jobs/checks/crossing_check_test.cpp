// SPDX-License-Identifier: MIT
// A result that meets itself where the input does not is said to, wherever its parts lie.
#include "jobs/checks/crossing_check.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "remesher.h"
#include "support/hostile_shapes.h"

using namespace remesher;

namespace {

const TriangleMesh kApart = soups::joined({soups::cube(0, 2), soups::cube(3, 5)});
const TriangleMesh kCrossing = soups::joined({soups::cube(0, 2), soups::cube(1, 3)});

io::Part placed(const TriangleMesh& mesh, const Vec3& by) {
  return {"", mesh, {Transform(Eigen::Translation3d(by))}};
}

std::size_t countOf(const std::vector<Warning>& warnings) {
  for (const Warning& warning : warnings)
    if (warning.code == "SELF_INTERSECTIONS_MADE") return warning.count;
  return 0;
}

}  // namespace

TEST_CASE("crossing check: triangles count that meet others where none of the original does") {
  CHECK(crossingsMade(kApart, kApart).empty());
  CHECK(!crossingsMade(kApart, kCrossing).empty());
  CHECK(crossingsMade(kCrossing, kCrossing).empty());
  CHECK(crossingsMade(kCrossing, kApart).empty());
}

TEST_CASE("crossing check: only crossings near by excuse those of the result") {
  TriangleMesh far = kCrossing;
  for (Vec3& p : far.positions) p.x() += 100;
  const TriangleMesh original = soups::joined({kApart, far});
  const TriangleMesh result = soups::joined({kCrossing, far});
  bool isCrossed = false;
  CHECK(crossingsMade(original, result) == crossingsMade(kApart, kCrossing));
  CHECK(!crossingsMade(original, kCrossing, &isCrossed).empty());
  CHECK(isCrossed);
  CHECK(!crossingsMade(kApart, kCrossing, &isCrossed).empty());
  CHECK(!isCrossed);
  CHECK(crossingsMade(kCrossing, kCrossing, &isCrossed).empty());
  CHECK(isCrossed);
}

TEST_CASE("crossing check: parts are looked at together, where they are shown") {
  const TriangleMesh cube = soups::cube(0, 2);
  const std::vector<io::Part> apart = {placed(cube, {0, 0, 0}), placed(cube, {2.5, 0, 0})};
  std::vector<io::Part> grown = apart;
  for (Vec3& p : grown[1].mesh.positions) p.x() -= 1;
  const std::vector<PartPlace> places = placesOf(apart);
  CHECK(crossingsMade({apart, apart, places}, {{}, {}}).count == 0);
  const MadeCrossings made = crossingsMade({apart, grown, places}, {{}, {}});
  CHECK(made.count > 0);
  CHECK(countOf(warningsOf(made, grown)) == made.count);
  CHECK(crossingsMade({grown, grown, places}, {{}, {}}).count == 0);
  CHECK(warningsOf({}, grown).empty());
}

TEST_CASE("crossing check: a run makes no self-intersections, or says how many") {
  // Two spheres, one in the other, nearer to each other than edges of the result can follow.
  for (const double inner : {0.97, 0.99}) {
    TriangleMesh ball = shapes::icosphere(8), core = shapes::turnedOver(ball);
    for (Vec3& p : core.positions) p *= inner;
    const TriangleMesh shell = soups::joined({ball, core});
    for (const Index vertices : {120U, 300U}) {
      CAPTURE(inner);
      CAPTURE(vertices);
      RemeshOptions options;
      options.vertices = vertices;
      const RemeshResult result = remesh(shell, options);
      const std::size_t made = crossingsMade(shell, result.mesh).size();
      CHECK(countOf(result.report.warnings) == made);
      CHECK(result.report.output->vertices == vertices);
      const RemeshSceneResult scene =
          remeshScene({{ball, {}}, {core, {Transform(Eigen::Scaling(1.0))}}}, options);
      const std::size_t all =
          crossingsMade(shell, soups::joined({scene.meshes[0], scene.meshes[1]})).size();
      CHECK((countOf(scene.report.warnings) > 0) == (all > 0));
    }
  }
}
