// SPDX-License-Identifier: MIT
#include "original/curves/feature_curves.h"

#include <doctest/doctest.h>

#include <set>

#include "support/working_meshes.h"

using namespace remesher;

namespace {

std::size_t cornerCount(const OriginalSurface& surface) {
  std::size_t count = 0;
  for (Index v = 0; v < surface.mesh().vertexCapacity(); ++v)
    count += surface.curves().isCorner(Vertex(v));
  return count;
}

double totalLength(const FeatureCurves& curves) {
  double sum = 0;
  for (const Chain& chain : curves.chains()) sum += chain.length();
  return sum;
}

}  // namespace

TEST_CASE("feature_curves: chains run over their edges, from corner to another corner") {
  for (const shapes::Shape& shape : shapes::all()) {
    CAPTURE(shape.name);
    const OriginalSurface surface = shapes::surfaceOf(shape.mesh);
    const HalfedgeMesh& mesh = surface.mesh();
    std::set<Halfedge> used;
    for (Index c = 0; c < surface.curves().chains().size(); ++c) {
      const Chain& chain = surface.curves().chains()[c];
      REQUIRE(chain.vertices.size() == chain.halfedges.size() + 1);
      REQUIRE(chain.arcs.size() == chain.vertices.size());
      CHECK(chain.vertices.front() != chain.vertices.back());
      for (std::size_t i = 0; i < chain.vertices.size(); ++i)
        CHECK(surface.curves().isCorner(chain.vertices[i]) ==
              (i == 0 || i + 1 == chain.vertices.size()));
      for (std::size_t i = 0; i < chain.halfedges.size(); ++i) {
        const Halfedge h = chain.halfedges[i];
        const Vertex from = chain.vertices[i], to = chain.vertices[i + 1];
        CHECK((mesh.origin(h) == from ? mesh.tip(h) == to
                                      : mesh.origin(h) == to && mesh.tip(h) == from));
        CHECK(surface.curves().chain(h) == c);
        CHECK(mesh.isBoundary(h) == chain.boundary);
        CHECK(chain.arcs[i + 1] - chain.arcs[i] ==
              doctest::Approx((surface.positions()[to] - surface.positions()[from]).norm()));
        CHECK(used.insert(mesh.isEdge(h) ? h : mesh.twin(h)).second);
      }
    }
    std::size_t marked = 0;
    for (Index h = 0; h < mesh.halfedgeCapacity(); ++h)
      marked += mesh.isEdge(Halfedge(h)) && surface.curves().isCurve(Halfedge(h));
    CHECK(used.size() == marked);
  }
}

TEST_CASE("feature_curves: a cube has 12 chains between 8 corners") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::cube(3));
  CHECK(surface.curves().chains().size() == 12);
  CHECK(cornerCount(surface) == 8);
  CHECK(totalLength(surface.curves()) == doctest::Approx(12 * 3));
}

TEST_CASE("feature_curves: a closed rim is divided at three corners") {
  // The sides of a cylinder of 16 bend by 22.5°, its rims by 90°.
  const OriginalSurface surface = shapes::surfaceOf(shapes::cylinder(16, 3));
  CHECK(surface.curves().chains().size() == 2 * 3);
  CHECK(cornerCount(surface) == 2 * 3);
  CHECK(totalLength(surface.curves()) ==
        doctest::Approx(2 * 16 * 2 * std::sin(std::numbers::pi / 16)));
}

TEST_CASE("feature_curves: the boundary of a rectangle has its four corners") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::grid(5, 4));
  CHECK(surface.curves().chains().size() == 4);
  CHECK(cornerCount(surface) == 4);
  CHECK(totalLength(surface.curves()) == doctest::Approx(2 * (5 + 4)));
}

TEST_CASE("feature_curves: near a junction a bend is no corner of its own") {
  const BuiltMesh built = buildMesh(shapes::grid(20, 20));
  // Up along x = 10; and from its middle one to the right, then up along x = 11.
  const auto isOn = [](const Vec3& p) { return p.x() == 10 || (p.x() == 11 && p.y() >= 10); };
  const auto isBetween = [](const Vec3& a, const Vec3& b) {
    return a.x() != b.x() && !(a.y() == 10 && b.y() == 10);
  };
  CurveRules rules;
  Vertex bend;
  for (Index i = 0; i < built.mesh.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    const Vec3 &a = built.positions[built.mesh.origin(h)], &b = built.positions[built.mesh.tip(h)];
    if (a.x() == 11 && a.y() == 10) bend = built.mesh.origin(h);
    if (built.mesh.isEdge(h) && isOn(a) && isOn(b) && !isBetween(a, b)) rules.edges.push_back(h);
  }
  rules.size = 1;
  CHECK(FeatureCurves(built.mesh, built.positions, rules).isCorner(bend));
  rules.size = 4;
  CHECK_FALSE(FeatureCurves(built.mesh, built.positions, rules).isCorner(bend));
}

TEST_CASE("feature_curves: a boundary to keep has a corner at each vertex") {
  const BuiltMesh built = buildMesh(shapes::grid(5, 4));
  CurveRules rules;
  rules.keepBoundary = true;
  const FeatureCurves curves(built.mesh, built.positions, rules);
  CHECK(curves.chains().size() == 2 * (5 + 4));
  for (Index v = 0; v < built.mesh.vertexCapacity(); ++v)
    CHECK(curves.isCorner(Vertex(v)) == built.mesh.isBoundary(Vertex(v)));
}

TEST_CASE("feature_curves: a place on a chain is as far along it as it says") {
  for (const TriangleMesh& input : {shapes::cube(3), shapes::cylinder(16, 3), shapes::grid(5, 4)}) {
    const OriginalSurface surface = shapes::surfaceOf(input);
    const FeatureCurves& curves = surface.curves();
    for (Index c = 0; c < curves.chains().size(); ++c) {
      const Chain& chain = curves.chains()[c];
      for (std::size_t i = 0; i + 1 < chain.vertices.size(); ++i)
        for (const double t : {0.0, 0.3, 1.0}) {
          const CurvePoint point{c, chain.arcs[i] + t * (chain.arcs[i + 1] - chain.arcs[i])};
          const auto place = curves.locate(surface.mesh(), surface.positions(), point);
          const Vec3 from = surface.positions()[chain.vertices[i]];
          const Vec3 to = surface.positions()[chain.vertices[i + 1]];
          CHECK((place.position - (from + t * (to - from))).norm() < 1e-12);
          CHECK((surface.position(place.at) - place.position).norm() < 1e-12);
          CHECK(curves.chain(place.edge) == c);
        }
    }
  }
}

TEST_CASE("feature_curves: left of the way there is the other side of the way back") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::cube(3));
  const FeatureCurves& curves = surface.curves();
  for (Index c = 0; c < curves.chains().size(); ++c) {
    const CurvePoint here{c, 1.3}, there{c, 2.2};
    const SurfacePoint left = curves.leftOf(surface.mesh(), here, there);
    const SurfacePoint right = curves.leftOf(surface.mesh(), here, {c, 0.4});
    const Vec3 place = curves.locate(surface.mesh(), surface.positions(), here).position;
    CHECK((surface.position(left) - place).norm() < 1e-12);
    CHECK((surface.position(right) - place).norm() < 1e-12);
    CHECK(std::abs(surface.normal(left).dot(surface.normal(right))) < 1e-12);
    // Outside is up, so left of the way ahead is up × ahead.
    const Vec3 ahead = curves.locate(surface.mesh(), surface.positions(), there).position - place;
    const auto [a, b, d] = surface.mesh().vertices(left.face);
    const Vec3 middle =
        (surface.positions()[a] + surface.positions()[b] + surface.positions()[d]) / 3;
    CHECK(surface.normal(left).cross(ahead).dot(middle - place) > 0);
  }
}

TEST_CASE("feature_curves: of a boundary there is one side, whatever rounding makes of its arcs") {
  TriangleMesh input = shapes::grid(5, 4);
  for (Vec3& p : input.positions)  // beside these edges the others add nothing
    if (p.x() == 0 || p.x() == 5) p.x() = p.x() == 0 ? -1e20 : 1e20;
  const OriginalSurface surface = shapes::surfaceOf(input);
  const WorkingMesh mesh(surface);
  for (Index h = 0; h < mesh.mesh().halfedgeCapacity(); ++h) {
    const SurfacePoint point = mesh.cornerPoint(Halfedge(h));
    REQUIRE(point.face.index < surface.mesh().faceCapacity());
    CHECK(point.barycentric.sum() == doctest::Approx(1));
  }
}
