// SPDX-License-Identifier: MIT
#include "geometry/polar_map.h"

#include <doctest/doctest.h>

#include <cmath>

#include "mesh/mesh_builder.h"
#include "support/shapes.h"
#include "support/soups.h"

using namespace remesher;

namespace {

double angle(const Vec2& a, const Vec2& b) {
  const double turned = std::atan2(cross(a, b), a.dot(b));
  return turned < 0 ? turned + 2 * std::numbers::pi : turned;
}

double angle(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

// Calls body(built, map, v) for the map of every inner vertex of every shape.
template <class Body>
void forEveryStar(Body body) {
  PolarMap map;
  for (const shapes::Shape& shape : shapes::all()) {
    CAPTURE(shape.name);
    const BuiltMesh built = buildMesh(shape.mesh);
    for (Index i = 0; i < built.mesh.vertexCapacity(); ++i) {
      CAPTURE(i);
      if (built.mesh.isBoundary(Vertex(i))) continue;
      map.build(built.mesh, built.positions, Vertex(i));
      body(built, map, Vertex(i));
    }
  }
}

}  // namespace

TEST_CASE("polar_map: spokes keep their lengths, angles their proportions, and close to 2π") {
  forEveryStar([](const BuiltMesh& built, const PolarMap& map, Vertex v) {
    REQUIRE(map.size() == built.mesh.valence(v));
    double flat = 0, curved = 0;
    for (int i = 0; i < map.size(); ++i) {
      const Vec3 spoke = built.positions[map.neighbor(i)] - built.positions[v];
      const Vec3 next = built.positions[map.neighbor(map.after(i))] - built.positions[v];
      CHECK(map.rim(i).norm() == doctest::Approx(spoke.norm()));
      flat += angle(map.rim(i), map.rim(map.after(i)));
      curved += angle(spoke, next);
    }
    CHECK(flat == doctest::Approx(2 * std::numbers::pi));
    for (int i = 0; i < map.size(); ++i) {
      const Vec3 spoke = built.positions[map.neighbor(i)] - built.positions[v];
      const Vec3 next = built.positions[map.neighbor(map.after(i))] - built.positions[v];
      CHECK(angle(map.rim(i), map.rim(map.after(i))) / flat ==
            doctest::Approx(angle(spoke, next) / curved));
    }
  });
}

TEST_CASE("polar_map: in the plane it is a rotation") {
  const BuiltMesh built = buildMesh(shapes::grid(4, 4));
  PolarMap map;
  for (Index v = 0; v < built.mesh.vertexCapacity(); ++v) {
    if (built.mesh.isBoundary(Vertex(v))) continue;
    map.build(built.mesh, built.positions, Vertex(v));
    for (int i = 0; i < map.size(); ++i)
      for (int k = 0; k < map.size(); ++k)
        CHECK((map.rim(i) - map.rim(k)).norm() ==
              doctest::Approx(
                  (built.positions[map.neighbor(i)] - built.positions[map.neighbor(k)]).norm()));
  }
}

TEST_CASE("polar_map: a place is located in the triangle and by the weights it was made from") {
  soups::Random random(51);
  forEveryStar([&](const BuiltMesh&, const PolarMap& map, Vertex) {
    for (int i = 0; i < map.size(); ++i) {
      const Vec2 &a = map.rim(i), &b = map.rim(map.after(i));
      if (!(cross(a, b) > 1e-9 * a.norm() * b.norm())) continue;
      Vec3 weights = random.point() + Vec3::Constant(0.01);
      weights /= weights.sum();
      const auto found = map.locate(weights[1] * a + weights[2] * b);
      REQUIRE(found);
      CHECK(found->triangle == i);
      CHECK((found->barycentric - weights).norm() < 1e-9);
    }
  });
}

TEST_CASE("polar_map: the vertex itself is found, a place beyond every spoke is not") {
  forEveryStar([](const BuiltMesh&, const PolarMap& map, Vertex) {
    double longest = 0;
    for (int i = 0; i < map.size(); ++i) longest = std::max(longest, map.rim(i).norm());
    CHECK_FALSE(map.locate(Vec2(1.01 * longest, 0)));
    CHECK_FALSE(map.locate(Vec2(0, -1.01 * longest)));
    const auto center = map.locate(Vec2::Zero());
    REQUIRE(center);
    CHECK(center->barycentric == Vec3(1, 0, 0));
  });
}

TEST_CASE("polar_map: an unfolded edge keeps the lengths of both triangles and lies flat") {
  for (const shapes::Shape& shape : shapes::all()) {
    CAPTURE(shape.name);
    const BuiltMesh built = buildMesh(shape.mesh);
    for (Index i = 0; i < built.mesh.halfedgeCapacity(); ++i) {
      const Halfedge h(i);
      if (built.mesh.isBoundary(h)) continue;
      const auto at = [&](Vertex v) { return built.positions[v]; };
      const Vec3 a = at(built.mesh.origin(h)), b = at(built.mesh.tip(h));
      const Vec3 c = at(built.mesh.opposite(h)), d = at(built.mesh.opposite(built.mesh.twin(h)));
      const UnfoldedEdge quad = unfold(built.mesh, built.positions, h);
      CHECK((quad.a - quad.b).norm() == doctest::Approx((a - b).norm()));
      CHECK((quad.b - quad.c).norm() == doctest::Approx((b - c).norm()));
      CHECK((quad.c - quad.a).norm() == doctest::Approx((c - a).norm()));
      CHECK((quad.a - quad.d).norm() == doctest::Approx((a - d).norm()));
      CHECK((quad.d - quad.b).norm() == doctest::Approx((d - b).norm()));
      CHECK(quad.c.y() >= 0);
      CHECK(quad.d.y() <= 0);
      CHECK(isLocallyDelaunay(quad) ==
            isLocallyDelaunay(unfold(built.mesh, built.positions, built.mesh.twin(h))));
    }
  }
}

TEST_CASE("polar_map: of a quad's two diagonals at least one is Delaunay, of a square both are") {
  soups::Random random(52);
  for (int round = 0; round < 1000; ++round) {
    const auto radius = [&] { return 0.5 + random.number(); };
    const Vec2 a(radius(), 0), c(0, radius()), b(-radius(), 0), d(0, -radius());
    // The same convex quad, seen from either diagonal.
    const bool first = isLocallyDelaunay({b, a, c, d}), second = isLocallyDelaunay({d, c, b, a});
    CHECK((first || second));
  }
  const Vec2 a(1, 0), b(-1, 0), c(0, 1), d(0, -1);
  CHECK(isLocallyDelaunay({b, a, c, d}));
  CHECK(isLocallyDelaunay({d, c, b, a}));
  CHECK(isLocallyDelaunay({b, a, 1.01 * c, d}));
  CHECK_FALSE(isLocallyDelaunay({b, a, 0.99 * c, d}));
}
