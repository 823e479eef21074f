// SPDX-License-Identifier: MIT
#include "remesh/quads/shape/fairing.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "original/surface/surface_walk.h"
#include "remesh/quads/mesh/quad_check.h"
#include "remesh/quads/pair/pairing.h"
#include "remesh/quads/shape/quad_star.h"
#include "support/quad_sheets.h"
#include "support/working_meshes.h"

using namespace remesher;

namespace {

constexpr Index kAround = 30, kAcross = 14;  // quads around the torus, and around its tube

// The place on the ground nearest to p.
Placement onGround(const WorkingMesh& ground, const Vec3& p) {
  const auto& positions = ground.surface().positions();
  Index nearest = 0;
  for (Index v = 0; v < positions.size(); ++v)
    if ((positions[Vertex(v)] - p).norm() < (positions[Vertex(nearest)] - p).norm()) nearest = v;
  const SurfacePoint start = ground.surface().at(Vertex(nearest));
  return ground.onSurface(closestPointFrom(ground.surface(), start, p));
}

// Quads on a torus whose rows go to and fro by a sixth of a side.
QuadMesh wavyTorus(const WorkingMesh& ground) {
  const auto place = [](double x, double y) {
    const double wave = int(x + 2 * y) % 2 == 0 ? 0.08 : -0.08;
    const double u = 2 * std::numbers::pi * (x + wave) / kAround;
    const double v = 2 * std::numbers::pi * (y - wave) / kAcross;
    const double r = 2 + std::cos(v);
    return Vec3(r * std::cos(u), r * std::sin(u), std::sin(v));
  };
  QuadMesh quads = shapes::quadSheet(kAround, kAcross, shapes::Wraps::BothWays, place);
  for (Placement& vertex : quads.vertices) vertex = onGround(ground, vertex.position);
  return quads;
}

// Σ |fourth difference|² along both rows through each vertex.
double ripple(const QuadMesh& quads) {
  const auto at = [&](Index x, Index y) {
    return quads.position(y % kAcross * kAround + x % kAround);
  };
  double sum = 0;
  for (Index y = 0; y < kAcross; ++y)
    for (Index x = 0; x < kAround; ++x) {
      const Vec3 along =
          at(x, y) - 4 * at(x + 1, y) + 6 * at(x + 2, y) - 4 * at(x + 3, y) + at(x + 4, y);
      const Vec3 across =
          at(x, y) - 4 * at(x, y + 1) + 6 * at(x, y + 2) - 4 * at(x, y + 3) + at(x, y + 4);
      sum += along.squaredNorm() + across.squaredNorm();
    }
  return sum;
}

// Σ squared distance of the middles of quads from the torus itself.
double away(const QuadMesh& quads) {
  double sum = 0;
  for (const auto& [a, b, c, d] : quads.quads) {
    const Vec3 p =
        (quads.position(a) + quads.position(b) + quads.position(c) + quads.position(d)) / 4;
    const double distance = std::hypot(std::hypot(p.x(), p.y()) - 2, p.z()) - 1;
    sum += distance * distance;
  }
  return sum;
}

// Σ of the squared cosines of all corners.
double skew(const QuadMesh& quads) {
  double sum = 0;
  for (const auto& quad : quads.quads)
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3 p = quads.position(quad[i]);
      const Vec3 out = quads.position(quad[(i + 1) % 4]) - p;
      const Vec3 in = quads.position(quad[(i + 3) % 4]) - p;
      sum += std::pow(out.normalized().dot(in.normalized()), 2);
    }
  return sum;
}

}  // namespace

TEST_CASE("fairing: quads of a smooth surface have smoother rows, better angles, and are nearer") {
  const OriginalSurface surface =
      shapes::surfaceOf(shapes::torus(4 * kAround, 4 * kAcross), shapes::Features::None);
  const WorkingMesh ground(surface);
  const QuadMesh before = wavyTorus(ground);
  QuadMesh after = before;
  WorkBudget work;
  fair(after, ground, work);
  CHECK(check(after) == "");
  CHECK(ripple(after) < 0.01 * ripple(before));
  CHECK(skew(after) < skew(before));
  CHECK(away(after) < 0.5 * away(before));
}

TEST_CASE("fairing: flat quads stay in their plane, and boundaries where they are") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::grid(12, 12));
  const WorkingMesh ground(surface);
  const FaceFrames frames(ground);
  const CrossField field = makeCrossField(ground, frames, 1);
  const QuadMesh before = splitPairs(ground, pairTriangles(ground, frames, field));
  QuadMesh after = before;
  WorkBudget work;
  fair(after, ground, work);
  CHECK(check(after) == "");
  for (Index v = 0; v < after.vertices.size(); ++v) {
    CHECK(after.position(v).z() == 0);
    if (before.vertices[v].kind != VertexKind::Interior)
      CHECK(after.position(v) == before.position(v));
  }
}

TEST_CASE("fairing: sharp edges stay, and no corner becomes worse than 30 degrees") {
  for (const TriangleMesh& shape : {shapes::cube(4), shapes::cylinder(24, 6)}) {
    const OriginalSurface surface = shapes::surfaceOf(shape);
    const WorkingMesh ground(surface);
    const FaceFrames frames(ground);
    const CrossField field = makeCrossField(ground, frames, 0.3);
    const QuadMesh before = splitPairs(ground, pairTriangles(ground, frames, field));
    QuadMesh after = before, changed = before;
    WorkBudget work;
    fair(after, ground, work);
    const MovingQuads then(changed, ground), now(after, ground);
    for (Index q = 0; q < after.quads.size(); ++q)
      CHECK(now.quality(q) >= std::min(0.5, then.quality(q)) - 1e-9);
    for (Index v = 0; v < after.vertices.size(); ++v)
      if (before.vertices[v].kind != VertexKind::Interior)
        CHECK(after.position(v) == before.position(v));
  }
}
