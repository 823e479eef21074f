// SPDX-License-Identifier: MIT
#include "remesh/conforming/conforming.h"

#include <doctest/doctest.h>

#include <cmath>

#include "geometry/mesh_tree.h"
#include "geometry/triangle.h"
#include "mesh/mesh_builder.h"
#include "support/mesh_check.h"
#include "support/parts.h"
#include "support/shapes.h"

using namespace remesher;

namespace {

std::unique_ptr<FacetedMesh> conforming(const BuiltMesh& built, double vertices) {
  const HalfedgeData<char> seams(built.mesh.halfedgeCapacity(), 0);
  return makeConforming(built, seams, std::size_t(std::lround(vertices)));
}

// Turned by odd angles, coordinates with so many digits behind the point.
TriangleMesh turned(TriangleMesh mesh, int digits) {
  const Eigen::AngleAxisd turn(0.7, Vec3(1, 2, 3).normalized());
  const double steps = std::pow(10.0, digits);
  for (Vec3& p : mesh.positions) {
    p = turn * p;
    for (double& c : p) c = std::round(c * steps) / steps;
  }
  return mesh;
}

struct Angles {
  double least = kInfinity, mean = 0;
};

Angles anglesOf(const FacetedMesh& mesh) {
  Angles result;
  const HalfedgeMesh& m = mesh.mesh();
  for (Index f = 0; f < m.faceCapacity(); ++f) {
    if (!m.isAlive(Face(f))) continue;
    const auto [a, b, c] = m.vertices(Face(f));
    const auto& p = mesh.positions();
    const double angle = degrees(minAngle(p[a], p[b], p[c]));
    result.least = std::min(result.least, angle);
    result.mean += angle / double(m.faceCount());
  }
  return result;
}

// The largest distance of the middles of edges and of the vertices from the other surface.
double farthest(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions,
                const MeshTree& other) {
  double result = 0;
  for (Index i = 0; i < mesh.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    if (!mesh.isEdge(h)) continue;
    const Vec3 &a = positions[mesh.origin(h)], &b = positions[mesh.tip(h)];
    for (const double share : {0.0, 0.25, 0.5, 0.75})
      result = std::max(result, other.nearest(a + share * (b - a)).distance);
  }
  return result;
}

void checkSame(const BuiltMesh& built, const FacetedMesh& mesh, double tolerance) {
  const MeshTree original(built.mesh, built.positions), made(mesh.mesh(), mesh.positions());
  CHECK(farthest(mesh.mesh(), mesh.positions(), original) <= tolerance);
  CHECK(farthest(built.mesh, built.positions, made) <= tolerance);
}

}  // namespace

TEST_CASE("conforming: the shape is the part's own at any number, and angles widen with it") {
  for (const TriangleMesh& part :
       {shapes::drilledPlate(8, 0.5), shapes::filletedBar(4), shapes::boxWithHole()}) {
    const BuiltMesh built = buildMesh(part);
    double before = 0;
    for (const double times : {1.0, 1.02, 1.3, 3.0, 10.0}) {
      CAPTURE(times);
      const double vertices = std::round(times * double(built.mesh.vertexCount()));
      const std::unique_ptr<FacetedMesh> mesh = conforming(built, vertices);
      REQUIRE(mesh);
      CHECK(check(mesh->mesh()) == "");
      CHECK(double(mesh->mesh().vertexCount()) == vertices);
      checkSame(built, *mesh, 1e-9);
      const Angles angles = anglesOf(*mesh);
      CHECK(angles.mean > before - 1);
      before = angles.mean;
    }
    CHECK(before > 35);
  }
}

TEST_CASE("conforming: where facets have room, angles are wide on average, and none is narrow") {
  const struct Case {
    TriangleMesh part;
    double times, mean, least;
  } cases[] = {{shapes::drilledPlate(8, 0.5), 6, 45, 20},
               {shapes::drilledPlate(8, 0.5), 10, 49, 25},
               {shapes::filletedBar(4), 10, 39.5, 20},
               {shapes::boxWithHole(), 4, 51.5, 28}};
  for (const Case& wanted : cases) {
    CAPTURE(wanted.mean);
    const BuiltMesh built = buildMesh(wanted.part);
    const double vertices = wanted.times * double(built.mesh.vertexCount());
    const std::unique_ptr<FacetedMesh> mesh = conforming(built, vertices);
    REQUIRE(mesh);
    CHECK(anglesOf(*mesh).mean > wanted.mean);
    CHECK(anglesOf(*mesh).least > wanted.least);
  }
}

TEST_CASE("conforming: vertices that the shape does not need may go") {
  const BuiltMesh built = buildMesh(shapes::cube(6));
  const std::unique_ptr<FacetedMesh> mesh = conforming(built, 20);
  REQUIRE(mesh);
  CHECK(mesh->mesh().vertexCount() == 20);
  checkSame(built, *mesh, 1e-12);
  CHECK(conforming(built, 8));
  CHECK_FALSE(conforming(built, 7));
}

TEST_CASE("conforming: the rounding of turned coordinates mixes no facets") {
  for (int i = 0; i < 14; ++i) {
    CAPTURE(i);
    const Eigen::AngleAxisd turn(0.1 + 0.13 * i, Vec3(1, 2, 3 + i).normalized());
    TriangleMesh cube = shapes::cube(12);
    for (Vec3& p : cube.positions) p = turn * (p / 6 - Vec3::Ones());
    const BuiltMesh built = buildMesh(cube);
    for (const double vertices : {30.0, 40.0, 50.0}) {
      const std::unique_ptr<FacetedMesh> mesh = conforming(built, vertices);
      REQUIRE(mesh);
      checkSame(built, *mesh, 1e-9);
    }
  }
}

TEST_CASE("conforming: a turned part with six digits is meshed as well as the part itself") {
  const TriangleMesh plate = shapes::drilledPlate(8, 0.5);
  const BuiltMesh built = buildMesh(plate), rounded = buildMesh(turned(plate, 5));
  const double vertices = 4 * double(built.mesh.vertexCount());
  const std::unique_ptr<FacetedMesh> mesh = conforming(built, vertices);
  const std::unique_ptr<FacetedMesh> other = conforming(rounded, vertices);
  REQUIRE(mesh);
  REQUIRE(other);
  checkSame(rounded, *other, 5e-5);
  CHECK(anglesOf(*other).mean > anglesOf(*mesh).mean - 1);
  CHECK(anglesOf(*other).least > anglesOf(*mesh).least - 5);
}

TEST_CASE("conforming: seams stay edges, and those that end within a plane are refused") {
  const BuiltMesh built = buildMesh(shapes::grid(6, 6));
  const HalfedgeMesh& m = built.mesh;
  HalfedgeData<char> seams(m.halfedgeCapacity(), 0);
  const auto mark = [&](int from, int to) {
    for (Index i = 0; i < m.halfedgeCapacity(); ++i) {
      const Vec3 &a = built.positions[m.origin(Halfedge(i))],
                 &b = built.positions[m.tip(Halfedge(i))];
      const double low = std::min(a.y(), b.y()), high = std::max(a.y(), b.y());
      if (a.x() == 3 && b.x() == 3 && from <= low && high <= to) seams[Halfedge(i)] = 1;
    }
  };
  mark(0, 3);
  CHECK_FALSE(makeConforming(built, seams, 60));
  mark(3, 6);
  const std::unique_ptr<FacetedMesh> mesh = makeConforming(built, seams, 60);
  REQUIRE(mesh);
  CHECK(mesh->mesh().vertexCount() == 60);
  for (Index f = 0; f < mesh->mesh().faceCapacity(); ++f) {
    if (!mesh->mesh().isAlive(Face(f))) continue;
    double least = 6, most = 0;
    for (const Vertex v : mesh->mesh().vertices(Face(f))) {
      least = std::min(least, mesh->positions()[v].x());
      most = std::max(most, mesh->positions()[v].x());
    }
    CHECK((least >= 3 || most <= 3));
  }
}

TEST_CASE("conforming: a point of a vertex in a facet is the vertex, on that facet's side") {
  const BuiltMesh built = buildMesh(shapes::drilledPlate(4, 0.5));
  const std::unique_ptr<FacetedMesh> mesh = conforming(built, 300);
  REQUIRE(mesh);
  for (Index f = 0; f < mesh->mesh().faceCapacity(); ++f) {
    if (!mesh->mesh().isAlive(Face(f))) continue;
    const auto [a, b, c] = mesh->mesh().vertices(Face(f));
    const auto& p = mesh->positions();
    const Vec3 normal = unitNormal(p[a], p[b], p[c]);
    for (const Vertex v : {a, b, c}) {
      const SurfacePoint point = mesh->pointIn(v, mesh->facet(Face(f)));
      const auto [i, j, k] = built.mesh.vertices(point.face);
      const auto& q = built.positions;
      const Vec3& w = point.barycentric;
      CHECK((w[0] * q[i] + w[1] * q[j] + w[2] * q[k] - p[v]).norm() < 1e-9);
      CHECK(unitNormal(q[i], q[j], q[k]).dot(normal) > 1 - 1e-9);
    }
  }
}

TEST_CASE("conforming: unrolled facets get wide angles, and edges stay as near as asked") {
  const struct Case {
    TriangleMesh part;
    double times, depth, mean;
  } cases[] = {{shapes::drilledPlate(16, 2), 8, 0.005, 44},
               {shapes::filletedBar(12), 14, 0.01, 42},
               {shapes::filletedBar(24), 14, 0.006, 44}};
  for (const Case& wanted : cases) {
    CAPTURE(wanted.depth);
    const BuiltMesh built = buildMesh(wanted.part);
    const double vertices = wanted.times * double(built.mesh.vertexCount());
    const HalfedgeData<char> seams(built.mesh.halfedgeCapacity(), 0);
    const auto unrolled = makeConforming(built, seams, std::size_t(vertices), {wanted.depth});
    const auto facets = conforming(built, vertices);
    REQUIRE(unrolled);
    CHECK(check(unrolled->mesh()) == "");
    CHECK(double(unrolled->mesh().vertexCount()) == std::floor(vertices));
    checkSame(built, *unrolled, wanted.depth);
    CHECK(anglesOf(*unrolled).mean > wanted.mean);
    CHECK(anglesOf(*unrolled).mean > anglesOf(*facets).mean + 2);
  }
}

TEST_CASE("conforming: without facets that bend little nothing is unrolled") {
  const BuiltMesh built = buildMesh(shapes::boxWithHole());
  const HalfedgeData<char> seams(built.mesh.halfedgeCapacity(), 0);
  CHECK_FALSE(makeConforming(built, seams, 100, {0.1}));
}
