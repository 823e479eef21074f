// SPDX-License-Identifier: MIT
#include "remesh/schemes/guided.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "support/shapes.h"

using namespace remesher;

namespace {

// A slanting circle on the unit sphere, at this distance from its middle.
Guide slantingCircle(double away, const Vec3& axis) {
  Guide guide{{}, GuideKind::Loop, true, "circle"};
  const Vec3 up = axis.normalized(), x = up.unitOrthogonal(), y = up.cross(x);
  for (int k = 0; k < 48; ++k) {
    const Vec3 p = shapes::onCircle(k, 48);
    guide.points.push_back(away * up + std::sqrt(1 - away * away) * (p.x() * x + p.y() * y));
  }
  return guide;
}

// How many sides of quads lie on the plane of the circle, and whether they form one closed chain.
struct SideRing {
  std::size_t sides = 0;
  bool isClosed = false;
};

SideRing chainOn(const TriangleMesh& quads, double away, const Vec3& axis) {
  const Vec3 up = axis.normalized();
  const std::vector<Index> corners = quadsOf(quads);
  std::map<Index, std::set<Index>> beside;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Index a = corners[i], b = corners[i / 4 * 4 + (i + 1) % 4];
    const auto isOn = [&](Index v) { return std::abs(quads.positions[v].dot(up) - away) < 0.01; };
    if (!isOn(a) || !isOn(b)) continue;
    beside[a].insert(b);
    beside[b].insert(a);
  }
  SideRing chain;
  if (beside.empty()) return chain;
  std::set<Index> seen;
  for (Index v = beside.begin()->first; seen.insert(v).second;) {
    if (beside[v].size() != 2) return chain;
    const Index next = *beside[v].begin(), other = *beside[v].rbegin();
    v = seen.contains(next) ? other : next;
    ++chain.sides;
  }
  chain.isClosed = seen.size() == beside.size();
  return chain;
}

bool saidIn(const RemeshOutcome& made, const std::string& code) {
  return std::any_of(made.warnings.begin(), made.warnings.end(),
                     [&](const Warning& warning) { return warning.code == code; });
}

PartOptions unmirrored(Index vertices) {
  PartOptions options;
  options.quads = true;
  options.vertices = vertices;
  options.symmetry = Symmetry::Off;
  return options;
}

}  // namespace

TEST_CASE("guided: a loop becomes a closed chain of sides; without it there is none") {
  const TriangleMesh sphere = shapes::icosphere(16);
  PartOptions options = unmirrored(600);
  const Vec3 axis(1, 2, 3);
  CHECK_FALSE(chainOn(remeshSurface(sphere, options, {}).mesh, 0.4, axis).isClosed);
  options.guides = {slantingCircle(0.4, axis)};
  const RemeshOutcome made = remeshSurface(sphere, options, {});
  const SideRing chain = chainOn(made.mesh, 0.4, axis);
  CHECK(chain.isClosed);
  CHECK(chain.sides >= 16);
  CHECK(!saidIn(made, "GUIDES_NOT_KEPT"));
}

TEST_CASE("guided: where planes mirror the quads, the guide of one side is on both") {
  const TriangleMesh sphere = shapes::icosphere(16);
  PartOptions options = unmirrored(600);
  options.symmetry = Symmetry::X;
  options.guides = {slantingCircle(0.8, {-1, 0, 0})};
  const RemeshOutcome made = remeshSurface(sphere, options, {});
  CHECK(saidIn(made, "GUIDES_MIRRORED"));
  CHECK(chainOn(made.mesh, 0.8, {-1, 0, 0}).isClosed);
  CHECK(chainOn(made.mesh, 0.8, {1, 0, 0}).isClosed);
}

TEST_CASE("guided: where planes are forced, a guide goes if its image is far from the other side") {
  // Narrower at one end.
  const auto narrowed = [](Vec3& p) {
    if (p.x() < 0) p.tail<2>() *= 1 + 0.7 * p.x();
  };
  TriangleMesh egg = shapes::icosphere(16);
  for (Vec3& p : egg.positions) narrowed(p);
  PartOptions options = unmirrored(600);
  options.guides = {slantingCircle(0.5, {-1, 0, 0})};
  for (Vec3& p : options.guides[0].points) narrowed(p);
  for (const Symmetry forced : {Symmetry::X, Symmetry::Y, Symmetry::Z}) {
    options.symmetry = forced;
    const RemeshOutcome made = remeshSurface(egg, options, {});
    CHECK(made.mirrors.size() == 1);
    CHECK(saidIn(made, "GUIDES_NOT_KEPT") == (forced == Symmetry::X));
  }
}

TEST_CASE("guided: guides go to the connected part that is nearest") {
  TriangleMesh two = shapes::icosphere(8);
  const auto count = Index(two.positions.size());
  const TriangleMesh other = shapes::icosphere(8);
  for (const Vec3& p : other.positions) two.positions.push_back(p + Vec3(3, 0, 0));
  for (const Index v : other.indices) two.indices.push_back(v + count);
  PartOptions options = unmirrored(500);
  Guide guide = slantingCircle(0.3, {0, 1, 2});
  for (Vec3& p : guide.points) p += Vec3(3, 0, 0);
  options.guides = {guide};
  RemeshOutcome made = remeshSurface(two, options, {});
  CHECK(!saidIn(made, "GUIDES_NOT_KEPT"));
  for (Vec3& p : made.mesh.positions) p -= Vec3(3, 0, 0);
  CHECK(chainOn(made.mesh, 0.3, {0, 1, 2}).isClosed);
}

TEST_CASE("guided: attributes are at their places, on both sides of a guide") {
  TriangleMesh sphere = shapes::icosphere(12);
  Attribute own{"COLOR_0", 3, {}};
  for (const Vec3& p : sphere.positions)
    for (int axis = 0; axis < 3; ++axis) own.values.push_back(float(p[axis]));
  sphere.attributes = {own};
  PartOptions options = unmirrored(400);
  options.guides = {slantingCircle(0.2, {0, 0, 1})};
  const RemeshOutcome made = remeshSurface(sphere, options, {});
  REQUIRE(made.mesh.attributes.size() == 1);
  for (std::size_t v = 0; v < made.mesh.positions.size(); ++v)
    for (std::size_t axis = 0; axis < 3; ++axis)
      CHECK(std::abs(made.mesh.attributes[0].values[3 * v + axis] -
                     made.mesh.positions[v][Eigen::Index(axis)]) < 0.03);
}
