// SPDX-License-Identifier: MIT
#include "remesh/quads/shape/fair_system.h"

#include <doctest/doctest.h>

#include "support/quad_sheets.h"

using namespace remesher;

TEST_CASE("fair system: what an even sheet has is solved by it, wherever the vertices begin") {
  constexpr Index kLong = 12, kWide = 7;
  const QuadMesh even = shapes::quadSheet(kLong, kWide, shapes::Wraps::No, shapes::flat);
  const QuadMesh start =
      shapes::quadSheet(kLong, kWide, shapes::Wraps::No, [](double x, double y) -> Vec3 {
        const double off = int(3 * x + 5 * y) % 4;
        return {x + 2 * off, y - off * off, 0.5 * off};
      });
  const QuadSides sides(start.vertices.size(), start.quads);
  FairSystem system(start, sides);
  REQUIRE(system.count() == start.vertices.size());
  system.clear();
  for (Index q = 0; q < even.quads.size(); ++q) {
    const auto& [a, b, c, d] = even.quads[q];
    const Quad corners = {even.position(a), even.position(b), even.position(c), even.position(d)};
    system.wantShape(q, corners);
    system.wantMiddle(q, (corners[0] + corners[1] + corners[2] + corners[3]) / 4);
  }
  for (Index v = 0; v < even.vertices.size(); ++v) system.wantVertex(v, even.position(v));
  const std::vector<Vec3> places = system.solve();
  for (Index v = 0; v < places.size(); ++v)
    CHECK((places[v] - even.position(v)).norm() < 1e-5 * kLong);
}
