// SPDX-License-Identifier: MIT
#include "remesh/quads/quads.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/quad.h"
#include "remesh/quads/mesh/quad_check.h"
#include "remesh/quads/quad_sizes.h"
#include "remesh/quads/shape/quad_star.h"
#include "remesh/schemes/remesh.h"
#include "support/working_meshes.h"

using namespace remesher;

namespace {

// A box whose edges are sharp or blunt: at 45°.
TriangleMesh wedge(int n) {
  TriangleMesh mesh = shapes::cube(n);
  for (Vec3& p : mesh.positions) p.x() += p.y();
  return mesh;
}

// A ring of n parts around the axis whose profile is a square of k × k cells: four sharp circles.
TriangleMesh squareRing(int n, int k) {
  TriangleMesh mesh;
  shapes::addSheet(mesh, n, 4 * k, [&](int x, int y) {
    const int side = y / k % 4, along = y % k;
    const double u = side == 0 ? along : side == 1 ? k : side == 2 ? k - along : 0;
    const double v = side == 0 ? 0 : side == 1 ? along : side == 2 ? k : k - along;
    return Vec3(shapes::onCircle(x, n) * (2 * k + u) + Vec3(0, 0, v));
  });
  return mesh;
}

// A ring of so many teeth with flat flanks, each shorter than a side of quads at few vertices.
TriangleMesh toothedRing(int teeth) {
  constexpr double kOutline[][2] = {{0, 1}, {0.18, 1.22}, {0.42, 1.22}, {0.6, 1}};
  TriangleMesh mesh;
  shapes::addSheet(mesh, 4 * teeth, 4, [&](int x, int y) {
    const auto& [turn, radius] = kOutline[x % 4];
    const double angle = 2 * std::numbers::pi * (x / 4 % teeth + turn) / teeth;
    const double r = y % 4 % 3 == 0 ? 0.4 : radius, z = y % 4 < 2 ? -0.14 : 0.14;
    return Vec3(r * std::cos(angle), r * std::sin(angle), z);
  });
  return mesh;
}

// Half of a cone in front of the plane y = 0, which goes through its tip: around the tip is so much
// of a full turn.
TriangleMesh halfCone(double turns) {
  constexpr int kSteps = 12;
  const double wide = 2 * turns, high = std::sqrt(1 - wide * wide);
  TriangleMesh mesh;
  shapes::addSheet(mesh, kSteps, kSteps, [&](int x, int y) {
    const double away = double(y) / kSteps;
    const Vec3 at = shapes::onCircle(x, 2 * kSteps) * wide * away;
    return Vec3(at.x(), x % kSteps == 0 ? 0 : at.y(), away * high);
  });
  return mesh;
}

MadeQuads madeOn(const WorkingMesh& ground, const QuadGoal& goal) {
  return makeQuads(goal, [&](std::size_t) { return ground; });
}

}  // namespace

TEST_CASE("quads: by the map or by pairs, each part is a surface of its own kind") {
  for (shapes::Shape shape : shapes::all()) {
    CAPTURE(shape.name);
    // In slivers a thousand times as long as wide nothing is square, and the search for it long.
    if (shape.name == "sliver fan")
      for (Vec3& p : shape.mesh.positions) p.y() *= 100;
    const OriginalSurface surface = shapes::surfaceOf(shape.mesh);
    const MadeQuads made = makeQuads({200}, [&](std::size_t) { return WorkingMesh(surface); });
    CHECK(check(made.mesh) == "");
    CHECK(kindOf(made.mesh) == SurfaceKind{shape.chi, shape.components, shape.loops});
    CHECK(made.parts == shape.components);
    CHECK(made.paired.size() <= made.parts);
  }
}

TEST_CASE("quads: the map reaches the number within a hundredth, with few irregular vertices") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::icosphere(9));
  const WorkingMesh ground(surface);
  WorkBudget work;
  const QuadMesh quads = mapToQuads(ground, 490, evenSizes, work);
  REQUIRE(check(quads) == "");
  CHECK(kindOf(quads) == SurfaceKind{2, 1, 0});
  // 2 (ab + bc + ca) + 2 with all three 9 is 488: few other numbers divide a sphere as evenly.
  CHECK(double(quads.vertices.size()) == doctest::Approx(490).epsilon(0.01));
}

TEST_CASE("quads: nothing folds at sharp edges, and each of them is followed") {
  for (const shapes::Shape& shape : {shapes::Shape{"box", shapes::cube(6), 2, 1, 0},
                                     shapes::Shape{"ring", squareRing(24, 4), 0, 1, 0},
                                     shapes::Shape{"wedge", wedge(6), 2, 1, 0}}) {
    CAPTURE(shape.name);
    const OriginalSurface surface = shapes::surfaceOf(shape.mesh);
    const WorkingMesh ground(surface);
    MadeQuads made = madeOn(ground, {300});
    REQUIRE(check(made.mesh) == "");
    CHECK(kindOf(made.mesh) == SurfaceKind{shape.chi, shape.components, shape.loops});
    CHECK(made.paired.empty());
    const MovingQuads moving(made.mesh, ground);
    std::vector<double> followed(surface.curves().chains().size(), 0);
    for (Index q = 0; q < made.mesh.quads.size(); ++q) {
      CHECK(moving.quality(q) > kLeastSine);
      for (Index i = 0; i < 4; ++i) {
        const Index chain = made.mesh.curves[q][i];
        if (chain == kNone) continue;
        const Vec3 &a = made.mesh.position(made.mesh.quads[q][i]),
                   &b = made.mesh.position(made.mesh.quads[q][(i + 1) % 4]);
        followed[chain] += (a - b).norm() / 2;
      }
    }
    for (Index c = 0; c < followed.size(); ++c)
      CHECK(followed[c] == doctest::Approx(surface.curves().chains()[c].length()).epsilon(0.05));
  }
}

TEST_CASE("quads: teeth shorter than quads are wide stay apart") {
  const TriangleMesh ring = toothedRing(14);
  PartOptions options;
  options.quads = true;
  for (const Index vertices : {300U, 500U}) {
    options.vertices = vertices;
    const RemeshOutcome made = remeshSurface(ring, options, {});
    CHECK(double(made.vertices) == doctest::Approx(vertices).epsilon(kFreeTolerance));
    CHECK(made.stopped == Stopped::Target);
    for (std::size_t i = 0; i < made.mesh.indices.size(); i += 6) {
      Quad quad;
      for (std::size_t k = 0; k < 4; ++k)
        quad[k] = made.mesh.positions[made.mesh.indices[i + (k < 3 ? k : 5)]];
      CHECK(leastSine(quad) > 0.5);
    }
  }
}

TEST_CASE("quads: of a ball hold the volume of the ball") {
  const auto sixVolumes = [](const TriangleMesh& mesh) {
    double sum = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
      sum += mesh.positions[mesh.indices[i]].dot(
          mesh.positions[mesh.indices[i + 1]].cross(mesh.positions[mesh.indices[i + 2]]));
    return sum;
  };
  const TriangleMesh ball = shapes::icosphere(12);
  PartOptions options;
  options.quads = true;
  std::vector<double> shares;
  for (const std::size_t vertices : {390, 400, 410}) {
    options.vertices = vertices;
    shares.push_back(sixVolumes(remeshSurface(ball, options, {}).mesh) / sixVolumes(ball));
  }
  std::sort(shares.begin(), shares.end());
  // With all vertices on the ball 1.7 % are missing. Where irregular vertices lie is chance.
  CHECK(shares[1] == doctest::Approx(1).epsilon(0.003));
}

TEST_CASE("quads: lines across a ball hardly bend where quads are large") {
  PartOptions options;
  options.quads = true;
  options.vertices = 600;
  const TriangleMesh mesh = remeshSurface(shapes::icosphere(12), options, {}).mesh;
  const std::vector<Index> quads = quadsOf(mesh);
  double off = 0;
  for (std::size_t i = 0; i < quads.size(); ++i) {
    const std::size_t first = i - i % 4;
    const auto at = [&](std::size_t k) { return mesh.positions[quads[first + (i + k) % 4]]; };
    const Vec3 out = (at(1) - at(0)).normalized(), back = (at(3) - at(0)).normalized();
    off += std::abs(std::acos(out.dot(back)) - std::numbers::pi / 2);
  }
  CHECK(off / double(quads.size()) < radians(2.6));
}

TEST_CASE("quads: an exact number is reached") {
  for (const TriangleMesh& shape : {shapes::cube(6), shapes::torus(24, 12)}) {
    const OriginalSurface surface = shapes::surfaceOf(shape);
    const MadeQuads made = madeOn(WorkingMesh(surface), {303, true});
    CHECK(check(made.mesh) == "");
    CHECK(made.mesh.vertices.size() == 303);
  }
}

TEST_CASE("quads: for an exact number that cannot be reached no quad folds") {
  TriangleMesh sliver = shapes::tetrahedron();
  for (Vec3& p : sliver.positions) p = {20 * p.x(), p.y(), 0.3 * p.z()};
  const OriginalSurface surface = shapes::surfaceOf(sliver);
  const WorkingMesh ground(surface);
  MadeQuads made = madeOn(ground, {4, true});
  CHECK(check(made.mesh) == "");
  CHECK(kindOf(made.mesh) == SurfaceKind{2, 1, 0});
  const MovingQuads moving(made.mesh, ground);
  for (Index q = 0; q < made.mesh.quads.size(); ++q) {
    CAPTURE(q);
    CHECK(leastSine(moving.corners(q)) > 0.01);
  }
}

TEST_CASE("quads: a half comes to the number of the whole, with sides along the plane") {
  TriangleMesh half = shapes::torus(24, 12);
  const std::vector<Vec3> all = half.positions;
  std::vector<Index> kept;
  for (std::size_t i = 0; i < half.indices.size(); i += 3) {
    const Index* const t = &half.indices[i];
    if ((all[t[0]] + all[t[1]] + all[t[2]]).y() > 0) kept.insert(kept.end(), t, t + 3);
  }
  half.indices = kept;
  for (Vec3& p : half.positions)
    if (std::abs(p.y()) < 1e-9) p.y() = 0;
  const OriginalSurface surface = shapes::surfaceOf(half);
  QuadGoal goal{600};
  goal.mirrors = {{{Vec3::UnitY(), 0}}, 1e-9, 600};
  const MadeQuads made = madeOn(WorkingMesh(surface), goal);
  REQUIRE(check(made.mesh) == "");
  CHECK(kindOf(made.mesh) == SurfaceKind{0, 1, 2});
  CHECK(double(wholeCount(made.mesh, goal.mirrors)) == doctest::Approx(600).epsilon(0.01));
  const QuadSides sides(made.mesh.vertices.size(), made.mesh.quads);
  for (Index v = 0; v < made.mesh.vertices.size(); ++v)
    CHECK(sides.isBoundary(v) == (made.mesh.position(v).y() == 0));
}

TEST_CASE("quads: between two sides on a plane that mirrors them there are two quads or more") {
  for (const double turns : {0.2, 0.28, 0.35}) {
    CAPTURE(turns);
    const OriginalSurface surface = shapes::surfaceOf(halfCone(turns), shapes::Features::None);
    QuadGoal goal{400};
    goal.mirrors = {{{Vec3::UnitY(), 0}}, 1e-9, 400};
    const MadeQuads made = madeOn(WorkingMesh(surface), goal);
    REQUIRE(check(made.mesh) == "");
    for (const Four<Index>& quad : made.mesh.quads) {
      const auto onPlane = std::count_if(quad.begin(), quad.end(),
                                         [&](Index v) { return made.mesh.position(v).y() == 0; });
      CHECK(onPlane <= 2);
    }
  }
}

TEST_CASE("quads: where triangles are small, so are quads") {
  TriangleMesh sheet = shapes::grid(24, 16);
  for (Vec3& p : sheet.positions) p.x() += p.x() * p.x() / 24;  // columns from 1 to 3 wide
  const OriginalSurface surface = shapes::surfaceOf(sheet);
  QuadGoal goal{300};
  goal.isGraded = true;
  const MadeQuads made = madeOn(WorkingMesh(surface), goal);
  REQUIRE(check(made.mesh) == "");
  double fine = 0, coarse = 0;  // quads per area at both ends
  for (const Four<Index>& quad : made.mesh.quads) {
    const double x = (made.mesh.position(quad[0]) + made.mesh.position(quad[2])).x() / 2;
    if (x < 12) fine += 1;
    if (x > 36) coarse += 1;
  }
  CHECK(fine > 1.2 * coarse);
}

TEST_CASE("quads: teeth that need up to half as many quads again get them from the map") {
  const OriginalSurface surface = shapes::surfaceOf(toothedRing(14));
  const WorkingMesh ground(surface);
  for (const double wanted : {140., 150., 160., 200.}) {
    CAPTURE(wanted);
    WorkBudget work;
    const QuadMesh quads = mapToQuads(ground, wanted, evenSizes, work);
    REQUIRE(check(quads) == "");
    CHECK(kindOf(quads) == kindOf(ground.mesh()));
    CHECK(double(quads.vertices.size()) > wanted);
    CHECK(double(quads.vertices.size()) < 1.5 * wanted);
  }
}

TEST_CASE("quads: few quads are made of few triangles") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::icosphere(2));
  for (const std::size_t vertices : {8, 20, 60, 150}) {
    std::size_t most = 0;
    makeQuads({vertices}, [&](std::size_t asked) {
      most = std::max(most, asked);
      return WorkingMesh(surface);
    });
    CHECK(most <= 50 * vertices);
  }
}

TEST_CASE("quads: few vertices lose no tip that those of neighbouring numbers have") {
  TriangleMesh cone = shapes::cone(17);
  for (Vec3& p : cone.positions) p.z() *= 1.5;
  PartOptions options;
  options.quads = true;
  options.vertices = 35;
  const RemeshOutcome made = remeshSurface(cone, options, {});
  double highest = 0;
  for (const Vec3& p : made.mesh.positions) highest = std::max(highest, p.z());
  CHECK(highest > 2.8);
}

TEST_CASE("quads: tiny parts beside a body take no quads out of it") {
  TriangleMesh mesh = shapes::icosphere(8);
  for (Vec3& p : mesh.positions) p = 2 * p.cwiseProduct(Vec3(1, 1.4, 0.8));
  for (int i = 0; i < 10; ++i) {
    TriangleMesh cone = shapes::cone(6);
    for (Vec3& p : cone.positions) p = 0.05 * p + Vec3(3, 0.3 * i, 0);
    const auto first = Index(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), cone.positions.begin(), cone.positions.end());
    for (const Index v : cone.indices) mesh.indices.push_back(first + v);
  }
  PartOptions options;
  options.quads = true;
  for (const Index vertices : {800U, 1000U, 1500U}) {
    options.vertices = vertices;
    const RemeshOutcome made = remeshSurface(mesh, options, {});
    std::vector<int> quads(made.mesh.positions.size(), 0);
    for (std::size_t i = 0; i < made.mesh.indices.size(); i += 6)
      for (const std::size_t k : {0, 1, 2, 5}) ++quads[made.mesh.indices[i + k]];
    std::size_t irregular = 0;
    for (std::size_t v = 0; v < quads.size(); ++v)
      irregular += made.mesh.positions[v].x() < 2.5 && quads[v] != 4;
    CHECK(irregular == 8);
    CHECK(double(made.vertices) == doctest::Approx(vertices).epsilon(kFreeTolerance));
  }
}

TEST_CASE("quads: where a dozen curves have too little room for each other quads stay near") {
  constexpr Index kAround = 12, kDown = 16;
  constexpr double kTop = 0.25;  // of the hole, in radians
  TriangleMesh ball;
  PartOptions options;
  for (Index y = 0; y <= kDown; ++y)
    for (Index x = 0; x < kAround; ++x) {
      const double down = kTop + (std::numbers::pi - kTop) * y / kDown;
      const double across = y == kDown ? 0 : std::sin(down);
      const Vec3 out = shapes::onCircle(int(x), kAround);
      ball.positions.push_back(across * out + Vec3(0, 0, 1.5 * std::cos(down)));
      if (y == kDown) continue;
      const Index a = y * kAround + x, b = y * kAround + (x + 1) % kAround;
      ball.indices.insert(ball.indices.end(), {a, a + kAround, b});
      if (y + 1 < kDown) ball.indices.insert(ball.indices.end(), {b, a + kAround, b + kAround});
      if (y == 0 || y + 1 == kDown) options.featureEdges.push_back({a, a + kAround});
    }
  options.quads = true;
  options.symmetry = Symmetry::Off;
  options.vertices = 700;
  const TriangleMesh quads = remeshSurface(ball, options, Progress()).mesh;
  double nearest = 1;
  for (std::size_t i = 0; i < quads.indices.size(); i += 3) {
    Vec3 middle = Vec3::Zero();
    for (std::size_t k = 0; k < 3; ++k) middle += quads.positions[quads.indices[i + k]] / 3;
    middle.z() /= 1.5;
    nearest = std::min(nearest, middle.norm());
  }
  CHECK(nearest > 0.85);
}
