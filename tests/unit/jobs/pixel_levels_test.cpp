// SPDX-License-Identifier: MIT
#include "jobs/pixel_levels.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "support/shapes.h"

namespace remesher {

namespace {

// A result of so many vertices that is so many pixels of 1080 away.
Report resultAt(double vertices, double pixels) {
  Report report;
  report.input.diagonal = 10;
  report.output = MeshReport{};
  report.output->vertices = std::size_t(vertices);
  report.fidelity = FidelityReport{100 * pixels / 1080, 0};
  return report;
}

}  // namespace

TEST_CASE("pixel levels: few results find a number near the fewest that do") {
  // Pixels of n vertices, as of smooth surfaces, of edges, and in steps.
  const auto smooth = [](double n) { return 4000 / n; };
  const auto edges = [](double n) { return 90 / std::sqrt(n); };
  const auto steps = [](double n) { return n < 700 ? 30.0 : 0.5; };
  for (const auto& pixelsOf : {std::function<double(double)>(smooth), {edges}, {steps}})
    for (const double asked : {1.0, 2.0, 4.0, 16.0}) {
      PixelSearch search(asked, 20000);
      int count = 0;
      double best = 0;
      while (!search.isSettled()) {
        const double vertices = search.vertices();
        if (search.take(resultAt(vertices, pixelsOf(vertices)))) best = vertices;
        ++count;
      }
      CAPTURE(asked);
      CAPTURE(best);
      CHECK(count <= 7);
      CHECK(search.isMet());
      CHECK(pixelsOf(best) <= asked);
      CHECK(pixelsOf(0.6 * best) > asked);
    }
}

TEST_CASE("pixel levels: what no number keeps ends with the nearest") {
  PixelSearch search(1, 5000);
  double best = 1e9, nearest = 1e9;
  while (!search.isSettled()) {
    const double vertices = search.vertices(), pixels = 3 + 100 / vertices;
    nearest = std::min(nearest, pixels);
    if (search.take(resultAt(vertices, pixels))) best = pixels;
  }
  CHECK_FALSE(search.isMet());
  CHECK(best == nearest);
}

TEST_CASE("pixel levels: a result that had to have more vertices ends the search") {
  PixelSearch search(2, 5000);
  CHECK(search.take(resultAt(double(search.vertices()) + 100, 1)));
  CHECK(search.isSettled());
}

TEST_CASE("pixel levels: coarser levels take over farther away, where they are seen as a pixel") {
  const Report finest = resultAt(1000, 0.1);
  Report first = resultAt(500, 2), second = resultAt(250, 8);
  first.takesOver = switchTo(first, finest);
  second.takesOver = switchTo(second, first);
  CHECK(second.takesOver->distance == doctest::Approx(4 * first.takesOver->distance));
  CHECK(second.takesOver->coverage == doctest::Approx(first.takesOver->coverage / 16));
  // At this distance the diagonal, seen at 50 degrees upright, has 540 pixels of 1080.
  const double seen = 10 * 1080 / (2 * first.takesOver->distance * std::tan(0.436332313));
  CHECK(seen == doctest::Approx(540));
  // A level that is nearer than the finer one does not take over before it.
  CHECK(switchTo(resultAt(100, 1), first).distance == first.takesOver->distance);
}

TEST_CASE("pixel levels: smaller parts of a scene cover less of the screen when they switch") {
  Report finest = resultAt(1000, 0.1);
  finest.lods = {resultAt(500, 4)};
  finest.lods[0].takesOver = switchTo(finest.lods[0], finest);
  std::vector<io::Part> parts(2);
  parts[0].mesh = parts[1].mesh = shapes::tetrahedron();
  for (Vec3& p : parts[1].mesh.positions) p *= 0.1;
  setCoverages(parts, finest);
  CHECK(parts[0].coverages.size() == 1);
  CHECK(parts[1].coverages[0] == doctest::Approx(parts[0].coverages[0] / 100));
}

}  // namespace remesher
