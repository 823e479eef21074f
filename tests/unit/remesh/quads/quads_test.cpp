// SPDX-License-Identifier: MIT
#include "remesh/quads/quads.h"

#include <doctest/doctest.h>

#include "remesh/quads/mesh/quad_check.h"
#include "remesh/quads/shape/quad_star.h"
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

MadeQuads madeOn(const WorkingMesh& ground, const QuadGoal& goal) {
  return makeQuads(goal, [&](std::size_t) { return ground; });
}

}  // namespace

TEST_CASE("quads: by the map or by pairs, each part is a surface of its own kind") {
  for (const shapes::Shape& shape : shapes::all()) {
    CAPTURE(shape.name);
    const OriginalSurface surface = shapes::surfaceOf(shape.mesh);
    const MadeQuads made = makeQuads({400}, [&](std::size_t) { return WorkingMesh(surface); });
    CHECK(check(made.mesh) == "");
    CHECK(kindOf(made.mesh) == SurfaceKind{shape.chi, shape.components, shape.loops});
    CHECK(made.parts == shape.components);
    CHECK(made.paired <= made.parts);
  }
}

TEST_CASE("quads: the map reaches the number within a hundredth, with few irregular vertices") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::icosphere(14));
  const QuadMesh quads = mapToQuads(WorkingMesh(surface), 1540);
  REQUIRE(check(quads) == "");
  CHECK(kindOf(quads) == SurfaceKind{2, 1, 0});
  // 2 (ab + bc + ca) + 2 with all three 16 is 1538: few other numbers divide a sphere as evenly.
  CHECK(double(quads.vertices.size()) == doctest::Approx(1540).epsilon(0.01));
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
    CHECK(made.paired == 0);
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

TEST_CASE("quads: an exact number is reached") {
  for (const TriangleMesh& shape : {shapes::cube(6), shapes::torus(24, 12)}) {
    const OriginalSurface surface = shapes::surfaceOf(shape);
    const MadeQuads made = madeOn(WorkingMesh(surface), {303, true});
    CHECK(check(made.mesh) == "");
    CHECK(made.mesh.vertices.size() == 303);
  }
}
