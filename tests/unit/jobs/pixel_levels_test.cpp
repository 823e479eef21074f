// SPDX-License-Identifier: MIT
#include "jobs/pixel_levels.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

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

}  // namespace remesher
