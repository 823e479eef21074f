// SPDX-License-Identifier: MIT
#include "textures/charts/unwrap.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>

#include "base/triangle_mesh.h"
#include "geometry/predicates.h"
#include "geometry/triangle.h"
#include "support/shapes.h"
#include "textures/charts/chart_growth.h"

using namespace remesher;

namespace {

// A grid of quads whose corner (i, j) lies at `place`; columns close where the ends coincide.
template <class Place>
TriangleMesh grid(Index columns, Index rows, const Place& place) {
  TriangleMesh mesh;
  for (Index j = 0; j <= rows; ++j)
    for (Index i = 0; i <= columns; ++i)
      mesh.positions.push_back(place(double(i) / columns, double(j) / rows));
  for (Index j = 0; j < rows; ++j)
    for (Index i = 0; i < columns; ++i) {
      const Index a = j * (columns + 1) + i, b = a + 1, c = b + columns + 1, d = a + columns + 1;
      mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
    }
  return mesh;
}

TriangleMesh sphere(int columns = 24, int rows = 12) {
  return grid(columns, rows, [](double u, double v) {
    const double a = 2 * std::numbers::pi * u, b = std::numbers::pi * (0.02 + 0.96 * v);
    return Vec3(std::sin(b) * std::cos(a), std::sin(b) * std::sin(a), std::cos(b));
  });
}

// Two turns of a ramp around a column: seen from above all of it lies over itself.
TriangleMesh ramp() {
  return grid(60, 2, [](double u, double v) {
    const double a = -4 * std::numbers::pi * u, r = 1 + v;
    return Vec3(r * std::cos(a), r * std::sin(a), u);
  });
}

TriangleMesh foldedSheet() {
  return grid(24, 6, [](double u, double v) {
    const double t = std::clamp((u - 0.45) / 0.1, 0.0, 1.0) * std::numbers::pi;
    const double x = u < 0.45 ? u : u > 0.55 ? 1 - u : 0.45 + 0.03 * std::sin(t);
    return Vec3(x, v, 0.01 * (1 - std::cos(t)));
  });
}

TriangleMesh waves(double height) {
  return grid(20, 20, [&](double u, double v) {
    return Vec3(u, v, height * std::sin(15 * u) * std::cos(12 * v));
  });
}

TriangleMesh tube() {
  const Index columns = 24;
  TriangleMesh mesh = grid(columns, 3, [](double u, double v) {
    const double a = 2 * std::numbers::pi * u;
    return Vec3(std::cos(a), std::sin(a), 4 * v);
  });
  for (Index& v : mesh.indices)
    if (v % (columns + 1) == columns) v -= columns;
  return mesh;
}

TriangleMesh cube() {
  TriangleMesh mesh;
  for (Index i = 0; i < 8; ++i) mesh.positions.emplace_back(i & 1, i >> 1 & 1, i >> 2);
  mesh.indices = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                  2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  return mesh;
}

// Rings of many sizes, with holes that smaller ones fit into: count squared of them.
TriangleMesh plates(Index count) {
  TriangleMesh mesh;
  for (Index i = 0; i < count * count; ++i) {
    const double size = 1 + i % 7, x = 20 * double(i / count), y = 20 * double(i % count);
    const TriangleMesh ring = grid(16, 1, [&](double u, double v) {
      const double a = -2 * std::numbers::pi * std::min(u, 0.9), r = size * (0.6 + 0.4 * v);
      return Vec3(x + r * std::cos(a), y + r * std::sin(a), 0);
    });
    const Index first = Index(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), ring.positions.begin(), ring.positions.end());
    for (const Index v : ring.indices) mesh.indices.push_back(first + v);
  }
  return mesh;
}

std::vector<char> noCuts(const TriangleMesh& mesh) {
  return std::vector<char>(mesh.indices.size(), 0);
}

// Whether an edge of one has all of the other on its outer side.
bool isApart(const PlaneTriangle& s, const PlaneTriangle& t) {
  for (int k = 0; k < 3; ++k)
    if (std::all_of(t.begin(), t.end(),
                    [&](const Vec2& p) { return orient2d(s[k], s[(k + 1) % 3], p) <= 0; }))
      return true;
  return false;
}

double distance(const Vec2& p, const Vec2& a, const Vec2& b) {
  const double t = std::clamp((p - a).dot(b - a) / std::max((b - a).squaredNorm(), 1e-300), 0., 1.);
  return (p - a - t * (b - a)).norm();
}

double distance(const PlaneTriangle& s, const PlaneTriangle& t) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      least = std::min(
          {least, distance(s[i], t[k], t[(k + 1) % 3]), distance(t[i], s[k], s[(k + 1) % 3])});
  return least;
}

struct Extent {
  std::array<double, 2> low, high;

  explicit Extent(const PlaneTriangle& t) {
    for (int k = 0; k < 2; ++k)
      std::tie(low[k], high[k]) = std::minmax({t[0][k], t[1][k], t[2][k]});
  }
  bool isFarFrom(const Extent& other, double gap) const {
    for (int k = 0; k < 2; ++k)
      if (low[k] > other.high[k] + gap || other.low[k] > high[k] + gap) return true;
    return false;
  }
};

struct Laid {
  TriangleMesh mesh;
  Unwrapped uv;
  PackingRules rules;

  explicit Laid(TriangleMesh m, PackingRules r = {512, 2})
      : mesh(std::move(m)), uv(unwrap({mesh.positions, mesh.indices, noCuts(mesh)}, r)), rules(r) {}
  PlaneTriangle plane(Index t) const {
    return {uv.corners[3 * t], uv.corners[3 * t + 1], uv.corners[3 * t + 2]};
  }
  Triangle surface(Index t) const {
    const auto p = [&](Index k) { return mesh.positions[mesh.indices[3 * t + k]]; };
    return {p(0), p(1), p(2)};
  }
  double density(Index t) const {
    const auto [a, b, c] = plane(t);
    const auto [p, q, r] = surface(t);
    return cross(b - a, c - a) / areaVector(p, q, r).norm() / uv.scale / uv.scale;
  }
  // How much longer one direction is drawn than the one that is drawn shortest: the singular values
  // of the map, whose squares' sum is its norm and whose product its determinant.
  double stretch(Index t) const {
    const auto [a, b, c] = plane(t);
    const auto [p, q, r] = surface(t);
    const Vec3 x = (q - p).normalized(), y = (q - p).cross(r - p).cross(x).normalized();
    Eigen::Matrix2d from, to;
    from << (q - p).dot(x), (r - p).dot(x), 0, (r - p).dot(y);
    to << b - a, c - a;
    const Eigen::Matrix2d map = to * from.inverse();
    const double half = map.squaredNorm() / std::abs(2 * map.determinant());
    return half + std::sqrt(std::max(0.0, half * half - 1));
  }
  double use() const {
    double sum = 0;
    for (Index t = 0; t < mesh.triangleCount(); ++t) {
      const auto [a, b, c] = plane(t);
      sum += 0.5 * cross(b - a, c - a);
    }
    return sum / rules.size / rules.size;
  }
};

void requireLaws(const Laid& laid) {
  REQUIRE(laid.uv.scale > 0);
  const Index count = Index(laid.mesh.triangleCount());
  double least = 1e300, most = 0;
  for (Index t = 0; t < count; ++t) {
    least = std::min(least, laid.density(t));
    most = std::max(most, laid.density(t));
    CHECK(laid.stretch(t) <= 1.51);
    for (const Vec2& p : laid.plane(t)) {
      CHECK(p.minCoeff() >= laid.rules.padding);
      CHECK(p.maxCoeff() <= laid.rules.size - laid.rules.padding);
    }
  }
  CHECK(least > 0);
  CHECK(most / least <= 1.5);
  std::vector<Extent> boxes;
  for (Index t = 0; t < count; ++t) boxes.emplace_back(laid.plane(t));
  std::size_t overlaps = 0, near = 0;
  for (Index s = 0; s < count; ++s)
    for (Index t = s + 1; t < count; ++t) {
      if (boxes[s].isFarFrom(boxes[t], 2 * laid.rules.padding)) continue;
      const PlaneTriangle a = laid.plane(s), b = laid.plane(t);
      if (laid.uv.charts[s] == laid.uv.charts[t])
        overlaps += !isApart(a, b) && !isApart(b, a);
      else
        near += distance(a, b) < 2 * laid.rules.padding;
    }
  CHECK(overlaps == 0);
  CHECK(near == 0);
}

}  // namespace

TEST_CASE("unwrap: no flips, no overlaps, even texels, padding") {
  for (const PackingRules& rules : {PackingRules{512, 2}, PackingRules{64, 1}}) {
    requireLaws(Laid(sphere(), rules));
    requireLaws(Laid(ramp(), rules));
    requireLaws(Laid(foldedSheet(), rules));
    requireLaws(Laid(waves(0.1), rules));
    requireLaws(Laid(waves(0.3), rules));
  }
}

TEST_CASE("unwrap: what is flat is one chart, a tube, a box, a sphere and a torus few") {
  const auto flat = [](double u, double v) { return Vec3(u, 2 * v, 0); };
  CHECK(Laid(grid(20, 20, flat)).uv.chartCount == 1);
  CHECK(Laid(tube()).uv.chartCount <= 2);
  CHECK(Laid(cube()).uv.chartCount <= 3);
  CHECK(Laid(sphere()).uv.chartCount <= 6);
  CHECK(Laid(shapes::torus(24, 24)).uv.chartCount <= 4);
}

TEST_CASE("unwrap: what can be laid flat is laid flat as it is") {
  for (const Laid& laid : {Laid(tube()), Laid(cube())})
    for (Index t = 0; t < laid.mesh.triangleCount(); ++t) {
      CHECK(laid.density(t) == doctest::Approx(1).epsilon(0.02));
      CHECK(laid.stretch(t) == doctest::Approx(1).epsilon(0.02));
    }
}

TEST_CASE("unwrap: rims are at cuts and at the outer border, nowhere else") {
  const auto flat = [](double u, double v) { return Vec3(u, v, 0); };
  const TriangleMesh mesh = grid(4, 4, flat);
  std::vector<char> cuts = noCuts(mesh), ends = cuts;
  for (Index h = 0; h < cuts.size(); ++h) {
    const Vec3& a = mesh.positions[mesh.indices[h]];
    const Vec3& b = mesh.positions[mesh.indices[h % 3 == 2 ? h - 2 : h + 1]];
    const auto isAlong = [&](Eigen::Index k, double at) { return a[k] == at && b[k] == at; };
    cuts[h] = isAlong(0, 0.5);
    ends[h] = cuts[h] || isAlong(0, 0) || isAlong(0, 1) || isAlong(1, 0) || isAlong(1, 1);
  }
  const Unwrapped uv = unwrap({mesh.positions, mesh.indices, cuts}, {256, 2});
  CHECK(uv.chartCount == 2);
  CHECK(uv.rims == ends);
  // Where charts only have to end somewhere the look goes on.
  const Laid closed(cube());
  CHECK(std::count(closed.uv.rims.begin(), closed.uv.rims.end(), 0) == 36);
}

TEST_CASE("unwrap: a square too small for its charts says so") {
  // Each takes nine texels at least, with its padding.
  const TriangleMesh mesh = plates(8);
  CHECK(unwrap({mesh.positions, mesh.indices, noCuts(mesh)}, {16, 1}).scale == 0);
}

TEST_CASE("unwrap: the square is used, by few charts and by many") {
  CHECK(Laid(sphere(), {1024, 4}).use() > 0.5);
  CHECK(Laid(plates(8), {1024, 1}).use() > 0.4);
  // Few charts need the right one first.
  double use = 0;
  for (const Index n : {12U, 16U, 20U, 22U}) use += Laid(shapes::torus(n, 12), {1024, 3}).use() / 4;
  CHECK(use > 0.55);
}

TEST_CASE("unwrap: no chart becomes so long that the square stays empty beside it") {
  double use = 0;
  for (const Index n : {20U, 22U, 24U, 26U}) use += Laid(shapes::torus(n, 24), {1024, 4}).use() / 4;
  CHECK(use > 0.48);
  CHECK(Laid(shapes::cylinder(30, 6), {1024, 4}).use() > 0.6);
}

TEST_CASE("unwrap: both triangles of a quad are in one chart, and share its places there") {
  for (const TriangleMesh& mesh : {sphere(), waves(0.1), foldedSheet()}) {
    UnwrapInput input{mesh.positions, mesh.indices, noCuts(mesh)};
    for (Index t = 0; t < mesh.triangleCount(); ++t) input.faces.push_back(t - t % 2);
    const Unwrapped unwrapped = unwrap(input, {512, 2});
    std::size_t split = 0;
    for (Index t = 0; t < mesh.triangleCount(); t += 2) {
      split += unwrapped.charts[t] != unwrapped.charts[t + 1];
      split += unwrapped.corners[3 * t] != unwrapped.corners[3 * t + 3];
      split += unwrapped.corners[3 * t + 2] != unwrapped.corners[3 * t + 4];
    }
    CHECK(split == 0);
  }
}
