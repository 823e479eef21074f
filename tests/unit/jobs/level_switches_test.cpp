// SPDX-License-Identifier: MIT
#include "jobs/level_switches.h"

#include <doctest/doctest.h>

#include <cmath>

#include "support/shapes.h"

namespace remesher {

namespace {

// A level of a model of diagonal 10 that is so many pixels of 1080 away.
Report levelAt(double pixels) {
  Report report;
  report.input.diagonal = 10;
  report.fidelity = FidelityReport{100 * pixels / 1080, 0};
  return report;
}

}  // namespace

TEST_CASE("level switches: coarser levels take over farther away, where they are seen as a pixel") {
  const Report finest = levelAt(0.1);
  Report first = levelAt(2), second = levelAt(8);
  first.takesOver = switchTo(first, finest);
  second.takesOver = switchTo(second, first);
  CHECK(second.takesOver->distance == doctest::Approx(4 * first.takesOver->distance));
  CHECK(second.takesOver->coverage == doctest::Approx(first.takesOver->coverage / 16));
  // At this distance the diagonal, seen at 50 degrees upright, has 540 pixels of 1080.
  const double seen = 10 * 1080 / (2 * first.takesOver->distance * std::tan(0.436332313));
  CHECK(seen == doctest::Approx(540));
  // A level that is nearer than the finer one does not take over before it.
  CHECK(switchTo(levelAt(1), first).distance == first.takesOver->distance);
}

TEST_CASE("level switches: smaller parts of a scene cover less of the screen when they switch") {
  Report finest = levelAt(0.1);
  finest.lods = {levelAt(4)};
  finest.lods[0].takesOver = switchTo(finest.lods[0], finest);
  std::vector<io::Part> parts(2);
  parts[0].mesh = parts[1].mesh = shapes::tetrahedron();
  for (Vec3& p : parts[1].mesh.positions) p *= 0.1;
  setCoverages(parts, finest);
  CHECK(parts[0].coverages.size() == 1);
  CHECK(parts[1].coverages[0] == doctest::Approx(parts[0].coverages[0] / 100));
}

}  // namespace remesher
