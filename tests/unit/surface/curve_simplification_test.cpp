// SPDX-License-Identifier: MIT
#include "surface/curve_simplification.h"

#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "support/shapes.h"
#include "support/surfaces.h"

using namespace remesher;

namespace {

constexpr int kSide = 20;

// The edges of a sheet along the line x = column, from one height to another.
std::vector<Halfedge> line(const surfaces::Surface& sheet, int column, double from = 0,
                           double to = kSide) {
  std::vector<Halfedge> edges;
  for (Index i = 0; i < sheet.mesh().halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    if (!sheet.mesh().isEdge(h)) continue;
    const Vec3 &a = sheet.positions()[sheet.mesh().origin(h)],
               &b = sheet.positions()[sheet.mesh().tip(h)];
    if (a.x() == column && b.x() == column && std::min(a.y(), b.y()) >= from &&
        std::max(a.y(), b.y()) <= to)
      edges.push_back(h);
  }
  return edges;
}

std::vector<Halfedge> both(std::vector<Halfedge> a, const std::vector<Halfedge>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

std::vector<Halfedge> simplified(const surfaces::Surface& sheet, const CurveEdges& curves,
                                 double size) {
  return simplifyCurves(sheet.mesh(), sheet.positions(), curves, size).edges;
}

}  // namespace

TEST_CASE("curve_simplification: of two curves nearer than half an edge one stays, whole") {
  const surfaces::Surface sheet = surfaces::surface("sheet", shapes::grid(kSide, kSide));
  const CurveEdges curves{both(line(sheet, 10), line(sheet, 11)), {}};
  const std::vector<Halfedge> kept = simplified(sheet, curves, 5);
  std::set<double> columns;
  for (const Halfedge h : kept) columns.insert(sheet.positions()[sheet.mesh().origin(h)].x());
  CHECK(columns.size() == 1);
  CHECK(kept.size() == kSide);
}

TEST_CASE("curve_simplification: curves with room for triangles between them stay") {
  const surfaces::Surface sheet = surfaces::surface("sheet", shapes::grid(kSide, kSide));
  const CurveEdges curves{both(line(sheet, 10), line(sheet, 11)), {}};
  CHECK(simplified(sheet, curves, 1).size() == 2 * kSide);
}

TEST_CASE("curve_simplification: fixed curves are not let go, nor returned") {
  const surfaces::Surface sheet = surfaces::surface("sheet", shapes::grid(kSide, kSide));
  CHECK(simplified(sheet, {line(sheet, 10), line(sheet, 11)}, 5).empty());
  CHECK(simplified(sheet, {line(sheet, 5), line(sheet, 11)}, 5).size() == kSide);
}

TEST_CASE("curve_simplification: loose ends stay only if an edge fits along them") {
  const surfaces::Surface sheet = surfaces::surface("sheet", shapes::grid(kSide, kSide));
  const CurveEdges curves{line(sheet, 10, 8, 12), {}};
  CHECK(simplified(sheet, curves, 4).size() == 4);
  CHECK(simplified(sheet, curves, 8).empty());
}

TEST_CASE("curve_simplification: a narrow strip is absorbed by what is beside it") {
  const surfaces::Surface sheet = surfaces::surface("sheet", shapes::grid(kSide, kSide));
  const CurveEdges curves{both(line(sheet, 10), line(sheet, 11)), {}};
  const SimplifiedCurves narrow = simplifyCurves(sheet.mesh(), sheet.positions(), curves, 5);
  for (Index f = 0; f < sheet.mesh().faceCapacity(); ++f) {
    const auto [a, b, c] = sheet.mesh().vertices(Face(f));
    const Vec3 middle = (sheet.positions()[a] + sheet.positions()[b] + sheet.positions()[c]) / 3;
    CHECK(bool(narrow.absorbed[Face(f)]) == (middle.x() > 10 && middle.x() < 11));
  }
  const SimplifiedCurves roomy = simplifyCurves(sheet.mesh(), sheet.positions(), curves, 1);
  for (const char one : roomy.absorbed.values()) CHECK_FALSE(one);
}
