// SPDX-License-Identifier: MIT
#include "original/curves/curve_simplification.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "geometry/triangle.h"
#include "support/shapes.h"
#include "support/surfaces.h"

using namespace remesher;

namespace {

constexpr int kSide = 20;

enum class Along { X, Y };

struct Line {
  Along axis;
  double at;  // where it crosses the other axis
  double from = 0, to = kSide;
};

// The edges of a sheet on a line.
std::vector<Halfedge> edgesOn(const surfaces::Surface& sheet, const Line& line) {
  const int along = line.axis == Along::X ? 0 : 1;
  std::vector<Halfedge> edges;
  for (Index i = 0; i < sheet.mesh().halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    if (!sheet.mesh().isEdge(h)) continue;
    const Vec3 &a = sheet.positions()[sheet.mesh().origin(h)],
               &b = sheet.positions()[sheet.mesh().tip(h)];
    if (a[1 - along] == line.at && b[1 - along] == line.at &&
        std::min(a[along], b[along]) >= line.from && std::max(a[along], b[along]) <= line.to)
      edges.push_back(h);
  }
  return edges;
}

// The edges along the line x = column, from one height to another.
std::vector<Halfedge> line(const surfaces::Surface& sheet, double column, double from = 0,
                           double to = kSide) {
  return edgesOn(sheet, {Along::Y, column, from, to});
}

std::vector<Halfedge> both(std::vector<Halfedge> a, const std::vector<Halfedge>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

std::vector<Halfedge> simplified(const surfaces::Surface& sheet, const CurveEdges& curves,
                                 double size) {
  return simplifyCurves(sheet.mesh(), sheet.positions(), curves, size).edges;
}

std::set<double> columnsOf(const surfaces::Surface& sheet, const std::vector<Halfedge>& edges) {
  std::set<double> columns;
  for (const Halfedge h : edges) columns.insert(sheet.positions()[sheet.mesh().origin(h)].x());
  return columns;
}

}  // namespace

TEST_CASE("curve_simplification: of two curves nearer than half an edge one stays, whole") {
  const surfaces::Surface sheet = surfaces::surface("sheet", shapes::grid(kSide, kSide));
  const CurveEdges curves{both(line(sheet, 10), line(sheet, 11)), {}};
  const std::vector<Halfedge> kept = simplified(sheet, curves, 5);
  CHECK(columnsOf(sheet, kept).size() == 1);
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

TEST_CASE("curve_simplification: a spur goes without the curve it leaves") {
  const surfaces::Surface sheet = surfaces::surface("sheet", shapes::grid(kSide, kSide));
  const CurveEdges curves{both(line(sheet, 10), edgesOn(sheet, {Along::X, 10, 10, 12})), {}};
  CHECK(simplified(sheet, curves, 2).size() == kSide + 2);
  const std::vector<Halfedge> kept = simplified(sheet, curves, 4);
  CHECK(kept.size() == kSide);
  CHECK(columnsOf(sheet, kept) == std::set<double>{10});
}

TEST_CASE("curve_simplification: a short bridge goes without the curves it joins") {
  const surfaces::Surface sheet = surfaces::surface("sheet", shapes::grid(kSide, kSide));
  const std::vector<Halfedge> bridge = edgesOn(sheet, {Along::X, 10, 10, 12});
  // From the bridge's end one curve runs on and one diagonally, through the middles of cells.
  std::vector<Halfedge> curves = both(line(sheet, 10), edgesOn(sheet, {Along::X, 10, 12, kSide}));
  for (Index i = 0; i < sheet.mesh().halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    const Vec3 &a = sheet.positions()[sheet.mesh().origin(h)],
               &b = sheet.positions()[sheet.mesh().tip(h)];
    const bool isDiagonal = a.x() - a.y() == 2 && b.x() - b.y() == 2 && a.x() >= 12 && b.x() >= 12;
    if (sheet.mesh().isEdge(h) && isDiagonal) curves.push_back(h);
  }
  REQUIRE(curves.size() == kSide + 8 + 8);
  CHECK(simplified(sheet, {both(bridge, curves), {}}, 2).size() == bridge.size() + curves.size());
  CHECK(simplified(sheet, {both(bridge, curves), {}}, 3).size() == curves.size());
}

TEST_CASE("curve_simplification: a strip joins the neighbour with most of its border") {
  const surfaces::Surface sheet = surfaces::surface("sheet", shapes::grid(kSide, kSide));
  const std::vector<Halfedge> strip = both(line(sheet, 10), line(sheet, 11));
  // What divides the other side leaves it half of the border.
  const CurveEdges right{both(strip, edgesOn(sheet, {Along::X, 10, 11, kSide})), {}};
  CHECK(simplified(sheet, right, 5).size() == kSide + 9);
  CHECK(columnsOf(sheet, simplified(sheet, right, 5)).count(10) == 0);
  const CurveEdges left{both(strip, edgesOn(sheet, {Along::X, 10, 0, 10})), {}};
  CHECK(simplified(sheet, left, 5).size() == kSide + 10);
  CHECK(columnsOf(sheet, simplified(sheet, left, 5)).count(11) == 0);
}

TEST_CASE("curve_simplification: strips with room together join each other") {
  const surfaces::Surface sheet = surfaces::surface("sheet", shapes::grid(kSide, kSide));
  std::vector<Halfedge> curves;
  for (const int column : {8, 9, 10, 11, 12, 13}) curves = both(curves, line(sheet, column));
  // Five strips one wide, of which none has room for edges 5 long.
  CHECK(columnsOf(sheet, simplified(sheet, {curves, {}}, 5)).size() == 2);
}

TEST_CASE("curve_simplification: where the surface bends less is narrow") {
  TriangleMesh step;
  shapes::addSheet(step, kSide, kSide, [](int x, int y) {
    return Vec3(std::min(x, 10) + std::max(0, x - 11), y, std::clamp(x - 10, 0, 1));
  });
  const surfaces::Surface bent = surfaces::surface("step", step);
  const surfaces::Surface flat = surfaces::surface("sheet", shapes::grid(kSide, kSide));
  std::vector<Halfedge> creases;  // of the upright strip, one high
  for (const Halfedge h : line(bent, 10)) {
    const double z = bent.positions()[bent.mesh().origin(h)].z();
    if (z == bent.positions()[bent.mesh().tip(h)].z()) creases.push_back(h);
  }
  REQUIRE(creases.size() == 2 * kSide);
  CHECK(simplified(bent, {creases, {}}, 2).size() == 2 * kSide);
  CHECK(simplified(flat, {both(line(flat, 10), line(flat, 11)), {}}, 2).size() == kSide);
  CHECK(simplified(bent, {creases, {}}, 5).size() == kSide);
}

TEST_CASE("curve_simplification: where a slab's walls stay, so do the edges between them") {
  const surfaces::Surface slab =
      surfaces::surface("slab", shapes::cells(kSide, [](int, int, int z) { return z == 0; }));
  std::vector<Halfedge> edges;
  for (Index i = 0; i < slab.mesh().halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    if (!slab.mesh().isEdge(h)) continue;
    const auto normal = [&](Halfedge side) {
      const auto [a, b, c] = slab.mesh().vertices(HalfedgeMesh::face(side));
      return areaVector(slab.positions()[a], slab.positions()[b], slab.positions()[c]);
    };
    if (normal(h).dot(normal(slab.mesh().twin(h))) == 0) edges.push_back(h);
  }
  REQUIRE(edges.size() == 2 * 4 * kSide + 4);
  // The walls are 1 high, between squares that have room for triangles of the largest size.
  for (const double size : {1.0, 2.0, 3.0, 6.0})
    CHECK(simplified(slab, {edges, {}}, size) == edges);
  CHECK(simplified(slab, {edges, {}}, 8) != edges);
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
