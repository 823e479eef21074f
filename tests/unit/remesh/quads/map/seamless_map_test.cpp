// SPDX-License-Identifier: MIT
#include "remesh/quads/map/seamless_map.h"

#include <doctest/doctest.h>

#include <cmath>

#include "remesh/quads/field/singularities.h"
#include "support/working_meshes.h"

using namespace remesher;

namespace {

struct Mapped {
  Mapped(const TriangleMesh& input, double length)
      : surface(shapes::surfaceOf(input)),
        mesh(surface),
        frames(mesh),
        field(makeCrossField(mesh, frames, length)),
        maker(mesh, field, FaceData<double>(mesh.mesh().faceCapacity(), 1.0)),
        map(maker.map(length).value()) {}

  OriginalSurface surface;
  WorkingMesh mesh;
  FaceFrames frames;
  CrossField field;
  MapMaker maker;
  SeamlessMap map;
};

bool isWhole(Fixed x) { return x % kUnit == 0; }

}  // namespace

TEST_CASE("seamless_map: both ends of every edge agree on the way across, which is whole") {
  for (const auto& [shape, length] :
       {std::pair{shapes::icosphere(8), 0.3}, std::pair{shapes::torus(36, 16), 0.3},
        std::pair{shapes::cube(6), 1.0}, std::pair{shapes::boxWithHole(), 0.5}}) {
    const Mapped m(shape, length);
    const HalfedgeMesh& mesh = m.mesh.mesh();
    for (Index i = 0; i < mesh.halfedgeCapacity(); ++i) {
      const Halfedge h(i), twin = mesh.twin(h);
      if (!twin) continue;
      const Transition across = m.map.across(mesh, h);
      CHECK(across(m.map.corners[h]) == m.map.corners[mesh.next(twin)]);
      CHECK(across(m.map.corners[mesh.next(h)]) == m.map.corners[twin]);
      CHECK(isWhole(across.shift.u));
      CHECK(isWhole(across.shift.v));
    }
  }
}

TEST_CASE("seamless_map: a closed surface has four singular vertices or more per unit of χ") {
  const Mapped sphere(shapes::icosphere(8), 0.3), torus(shapes::torus(36, 16), 0.3);
  CHECK(sphere.maker.singularCount() >= 8);
  CHECK(torus.maker.singularCount() % 2 == 0);
  CHECK(!sphere.maker.isSpent());
}

TEST_CASE(
    "seamless_map: curves lie on whole lines, corners and singular vertices on their crossings") {
  for (const TriangleMesh& shape :
       {shapes::cube(6), shapes::cylinder(32, 12), shapes::grid(9, 7)}) {
    const Mapped m(shape, 0.7);
    const VertexData<int> singular = quarterIndices(m.field, m.mesh, m.frames);
    for (Index i = 0; i < m.mesh.mesh().halfedgeCapacity(); ++i) {
      const Halfedge h(i);
      const MapPoint a = m.map.corners[h], b = m.map.corners[HalfedgeMesh::next(h)];
      if (m.mesh.isCurve(h)) CHECK(((a.u == b.u && isWhole(a.u)) || (a.v == b.v && isWhole(a.v))));
      const Vertex v = m.mesh.mesh().origin(h);
      if (m.mesh.kind(v) == VertexKind::Corner || singular[v] != 0)
        CHECK((isWhole(a.u) && isWhole(a.v)));
    }
  }
}

TEST_CASE("seamless_map: a rectangle of whole sides keeps its lengths") {
  const Mapped m(shapes::grid(12, 8), 1);
  CHECK(m.maker.countVertices(m.map) == doctest::Approx(13 * 9));
  for (Index f = 0; f < m.mesh.mesh().faceCapacity(); ++f)
    CHECK(double(m.map.area(Face(f))) / (double(kUnit) * double(kUnit)) ==
          doctest::Approx(1).epsilon(1e-4));
}

TEST_CASE("seamless_map: a map of triangles too large to be exact is none") {
  const Mapped m(shapes::grid(12, 8), 1);
  CHECK(m.maker.map(1.0 / 500));
  CHECK_FALSE(m.maker.map(1.0 / 520));
}

TEST_CASE("seamless_map: no triangle folds over on smooth shapes") {
  for (const auto& [shape, length] :
       {std::pair{shapes::icosphere(12), 0.2}, std::pair{shapes::torus(48, 20), 0.25}}) {
    const Mapped m(shape, length);
    for (Index f = 0; f < m.mesh.mesh().faceCapacity(); ++f) CHECK(m.map.area(Face(f)) > 0);
  }
}

TEST_CASE("seamless_map: a boundary that turns without corners is a unit long between its turns") {
  for (const int waves : {5, 7, 11, 14}) {
    TriangleMesh disk = shapes::grid(24, 24);
    for (Vec3& p : disk.positions) {
      const Vec3 q = p / 12 - Vec3(1, 1, 0);
      const double square = q.cwiseAbs().maxCoeff(),
                   wave = std::cos(waves * std::atan2(q.y(), q.x()));
      if (square > 0) p = q.normalized() * square * (1 + 0.1 * square * wave);
    }
    for (const double length : {0.3, 0.4, 0.5, 0.6, 0.7}) {
      const Mapped m(disk, length);
      const HalfedgeMesh& mesh = m.mesh.mesh();
      const auto isTurn = [&](Halfedge h) {  // at its origin
        return isWhole(m.map.corners[h].u) && isWhole(m.map.corners[h].v);
      };
      int turns = 0;
      for (Index i = 0; i < mesh.halfedgeCapacity(); ++i) {
        Halfedge h(i);
        if (!mesh.isBoundary(h) || !isTurn(h)) continue;
        ++turns;
        Fixed far = 0;
        do {
          const MapPoint gone = m.map.corners[HalfedgeMesh::next(h)] - m.map.corners[h];
          far += std::abs(gone.u + gone.v);  // one of them is 0
          h = HalfedgeMesh::next(h);
          while (!mesh.isBoundary(h)) h = HalfedgeMesh::next(mesh.twin(h));
        } while (!isTurn(h));
        CHECK(far >= kUnit);
      }
      CHECK(turns > 0);
    }
  }
}
