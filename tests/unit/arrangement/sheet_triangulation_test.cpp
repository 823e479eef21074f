// SPDX-License-Identifier: MIT
#include "arrangement/sheet_triangulation.h"

#include <doctest/doctest.h>

#include <set>

#include "support/soups.h"

using namespace remesher;

namespace {

bool hasEdge(const SheetTriangulation& sheet, Index a, Index b) {
  for (Index t = 0; t < sheet.triangleCount(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::array<Index, 3> c = sheet.triangle(t);
      if ((c[k] == a && c[(k + 1) % 3] == b) || (c[k] == b && c[(k + 1) % 3] == a)) return true;
    }
  return false;
}

void checkSound(const SheetTriangulation& sheet, const PointPool& points) {
  for (Index t = 0; t < sheet.triangleCount(); ++t) {
    const std::array<Index, 3> c = sheet.triangle(t);
    REQUIRE(points.turn(c[0], c[1], c[2], sheet.view()) == 1);
    for (Index k = 0; k < 3; ++k) {
      const Index n = sheet.neighbor(t, k);
      if (n == kNone) continue;
      bool isBack = false;
      for (Index l = 0; l < 3; ++l) isBack = isBack || sheet.neighbor(n, l) == t;
      REQUIRE(isBack);
    }
  }
}

}  // namespace

TEST_CASE("sheet: every point is a corner, and segments that do not cross are edges") {
  // A grid has many points on lines and circles.
  std::vector<Vec3> given;
  constexpr Index kSide = 7;
  for (Index i = 0; i < kSide * kSide; ++i)
    given.emplace_back(0.1 * (i % kSide), 0.1 * (i / kSide), 0.05 * (i % kSide));
  PointPool points(given);
  SheetTriangulation sheet(points, {0, 1, kSide});
  for (Index i = 0; i < kSide * kSide; ++i) sheet.insert((i * 29) % (kSide * kSide));
  for (Index i = 0; i + 2 * kSide < kSide * kSide; i += kSide)
    sheet.force({i, i + 2 * kSide - 1 + kSide, {{i, i + 3 * kSide - 1, kNone}}});
  checkSound(sheet, points);
  // Triangles of n points, three of them around all others.
  CHECK(sheet.triangleCount() == 2 * (kSide * kSide + 3) - 5);
}

TEST_CASE("sheet: segments that cross are split at one exact point") {
  for (std::uint64_t seed = 1; seed < 20; ++seed) {
    soups::Random random(seed);
    std::vector<Vec3> given;
    constexpr Index kLines = 12;
    for (Index i = 0; i < 2 * kLines; ++i) {
      const Vec3 p = random.point();
      given.emplace_back(p.x(), p.y(), 0);
    }
    PointPool points(given);
    SheetTriangulation sheet(points, {0, 1, 2});
    for (Index i = 0; i < 2 * kLines; ++i) sheet.insert(i);
    for (Index i = 0; i < kLines; ++i) sheet.force({2 * i, 2 * i + 1, {{2 * i, 2 * i + 1, kNone}}});
    sheet.widenAngles();
    checkSound(sheet, points);
    std::size_t crossings = 0;
    const FlatView view = sheet.view();
    for (Index i = 0; i < kLines; ++i)
      for (Index k = 0; k < i; ++k) {
        const Index a = 2 * i, b = a + 1, c = 2 * k, d = c + 1;
        if (points.turn(a, b, c, view) == points.turn(a, b, d, view) ||
            points.turn(c, d, a, view) == points.turn(c, d, b, view)) {
          continue;
        }
        ++crossings;
        CHECK_FALSE(hasEdge(sheet, a, b));
      }
    CHECK(sheet.triangleCount() == 2 * (2 * kLines + crossings + 3) - 5);
  }
}
