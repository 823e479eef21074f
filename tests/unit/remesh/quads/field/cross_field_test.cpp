// SPDX-License-Identifier: MIT
#include "remesh/quads/field/cross_field.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "mesh/topology.h"
#include "remesh/quads/field/singularities.h"
#include "support/working_meshes.h"

using namespace remesher;

namespace {

// How far an angle is from a multiple of 90°, radians.
double offCross(double angle) {
  const double quarter = std::numbers::pi / 2;
  return std::abs(angle - quarter * std::round(angle / quarter));
}

struct Field {
  explicit Field(const TriangleMesh& input, double length = 0.5)
      : surface(shapes::surfaceOf(input)),
        mesh(surface),
        frames(mesh),
        field(makeCrossField(mesh, frames, length)) {}

  int indexSum() const {
    const VertexData<int> indices = quarterIndices(field, mesh, frames);
    int sum = 0;
    for (const int index : indices.values()) sum += index;
    return sum;
  }
  std::size_t singularCount() const {
    const VertexData<int> indices = quarterIndices(field, mesh, frames);
    std::size_t count = 0;
    for (const int index : indices.values()) count += index != 0;
    return count;
  }

  OriginalSurface surface;
  WorkingMesh mesh;
  FaceFrames frames;
  CrossField field;
};

}  // namespace

TEST_CASE("cross_field: indices add up to Euler's characteristic [Poincaré–Hopf]") {
  for (const shapes::Shape& shape : {shapes::Shape{"sphere", shapes::icosphere(6), 2, 1, 0},
                                     shapes::Shape{"torus", shapes::torus(24, 12), 0, 1, 0},
                                     shapes::Shape{"tunnel", shapes::boxWithHole(), 0, 1, 0},
                                     shapes::Shape{"cylinder", shapes::cylinder(24, 8), 2, 1, 0}}) {
    CAPTURE(shape.name);
    Field field(shape.mesh);
    CHECK(field.indexSum() == 4 * shape.chi);
    WorkBudget work;
    cancelPairs(field.field, field.mesh, field.frames, 1, work);
    CHECK(field.indexSum() == 4 * shape.chi);
  }
}

TEST_CASE("cross_field: crosses lie along curves") {
  for (const TriangleMesh& shape : {shapes::cube(3), shapes::cylinder(24, 6), shapes::grid(6, 4)}) {
    const Field field(shape);
    std::size_t seen = 0;
    for (Index i = 0; i < field.mesh.mesh().halfedgeCapacity(); ++i) {
      const Halfedge h(i);
      if (!field.mesh.isCurve(h)) continue;
      ++seen;
      CHECK(offCross(field.frames.angle(h) - field.field.angle[HalfedgeMesh::face(h)]) < 1e-6);
    }
    CHECK(seen > 0);
  }
}

// A square's half, divided at the middle of its diagonal, as by a plane that mirrors the square.
TEST_CASE("cross_field: curves that meet at 45° in a triangle lie along different directions") {
  for (Index first = 0; first < 3; ++first) {
    CAPTURE(first);
    TriangleMesh half;
    half.positions = {{0, 0, 0}, {1, 1, 0}, {2, 2, 0}, {0, 2, 0}};
    for (const std::array<Index, 3>& triangle : {std::array<Index, 3>{0, 1, 3}, {1, 2, 3}})
      for (Index k = 0; k < 3; ++k) half.indices.push_back(triangle[(first + k) % 3]);
    const Field field(half);
    const HalfedgeMesh& mesh = field.mesh.mesh();
    std::size_t seen = 0;
    for (Index i = 0; i < mesh.halfedgeCapacity(); ++i) {
      const Halfedge out(i), other = HalfedgeMesh::prev(out);
      if (!field.mesh.isCurve(out) || !field.mesh.isCurve(other)) continue;
      ++seen;
      const double cross = field.field.angle[HalfedgeMesh::face(out)];
      long quarters = 0;
      for (const Halfedge h : {out, other}) {
        const double off = field.frames.angle(h) - cross;
        CHECK(offCross(off) == doctest::Approx(std::numbers::pi / 8));
        quarters += std::lround(off / (std::numbers::pi / 2));
      }
      CHECK(std::abs(quarters) % 2 == 1);
    }
    CHECK(seen == 2);
  }
}

TEST_CASE("cross_field: a plane rectangle has none but parallel crosses") {
  const Field field(shapes::grid(7, 5));
  CHECK(field.singularCount() == 0);
  for (Index i = 0; i < field.mesh.mesh().faceCapacity(); ++i) {
    const Vec2 x = field.frames.inFrame(Face(i), Vec3(1, 0, 0));
    CHECK(offCross(std::atan2(x.y(), x.x()) - field.field.angle[Face(i)]) < 1e-6);
  }
}

TEST_CASE("cross_field: the corners of a cube are singular, and nothing else is") {
  const Field field(shapes::cube(4));
  const VertexData<int> indices = quarterIndices(field.field, field.mesh, field.frames);
  for (Index i = 0; i < indices.size(); ++i)
    CHECK(indices[Vertex(i)] == int(field.mesh.kind(Vertex(i)) == VertexKind::Corner));
}

TEST_CASE("cross_field: turns are opposite from the other side, and bends small") {
  const Field field(shapes::torus(30, 14));
  const HalfedgeMesh& m = field.mesh.mesh();
  for (Index i = 0; i < m.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    CHECK(field.field.turn[h] == -field.field.turn[m.twin(h)]);
    CHECK(std::abs(field.field.bend(field.frames, m, h)) < std::numbers::pi / 4 + 1e-9);
  }
}

TEST_CASE("cross_field: opposite pairs that lie near each other go, and no new ones come") {
  Field field(shapes::icosphere(8));
  // A pair is made: one quarter turn more over the edges of a way of two edges.
  const HalfedgeMesh& m = field.mesh.mesh();
  const std::size_t before = field.singularCount();
  Halfedge h = m.outgoing(Vertex(0));
  for (int i = 0; i < 2; ++i) {
    ++field.field.turn[h];
    --field.field.turn[m.twin(h)];
    h = m.next(m.twin(m.next(h)));
  }
  WorkBudget work;
  cancelPairs(field.field, field.mesh, field.frames, 1, work);
  CHECK(field.singularCount() <= before);
  CHECK(field.indexSum() == 8);
}
