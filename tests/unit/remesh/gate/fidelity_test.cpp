// SPDX-License-Identifier: MIT
#include "remesh/gate/fidelity.h"

#include <doctest/doctest.h>

#include "base/part_options.h"
#include "remesh/gate/angles.h"
#include "remesh/operators/local_operators.h"
#include "support/working_meshes.h"

using namespace remesher;

namespace {

FidelityRule rule(Fidelity mode, double vertexAngle, double triangleAngle) {
  PartOptions options;
  options.fidelity = mode;
  options.vertexAngle = vertexAngle;
  options.triangleAngle = triangleAngle;
  return fidelityRule(options);
}

Vertex vertexAt(const WorkingMesh& mesh, const Vec3& position) {
  for (Index v = 0; v < mesh.mesh().vertexCapacity(); ++v)
    if ((mesh.position(Vertex(v)) - position).norm() < 1e-9) return Vertex(v);
  return {};
}

// v stays where it is: the gate looks at its star as it stands.
Verdict judgeStanding(const WorkingMesh& mesh, Vertex v, const FidelityRule& by) {
  LocalChange change;
  proposePlacement(mesh, v, mesh.placement(v), change);
  return judge(mesh, change, by);
}

Verdict judgeMove(const WorkingMesh& mesh, Vertex v, const Vec3& to, const FidelityRule& by) {
  LocalChange change;
  Placement place = mesh.placement(v);
  place.position = to;
  proposePlacement(mesh, v, place, change);
  return judge(mesh, change, by);
}

}  // namespace

TEST_CASE("fidelity: the angles of an icosahedron are let through from just above them") {
  // Its corners' normals are atan 2 apart, and as far from the faces' as the middle of a face from
  // its corner: acos of the in- to the circumradius.
  const OriginalSurface surface = shapes::surfaceOf(shapes::icosphere(1), shapes::Features::None);
  const WorkingMesh mesh(surface);
  const double g = std::numbers::phi;
  const double vertex = degrees(std::atan(2.0));
  const double triangle = degrees(std::acos(g * g / std::sqrt(3 * (g * g + 1))));
  for (const Fidelity mode : {Fidelity::Strict, Fidelity::Loose}) {
    const Vertex v(0);
    CHECK(judgeStanding(mesh, v, rule(mode, vertex + 0.01, triangle + 0.01)) == Verdict::Accepted);
    CHECK(judgeStanding(mesh, v, rule(mode, vertex - 0.01, 90)) == Verdict::VertexAngle);
    CHECK(judgeStanding(mesh, v, rule(mode, 90, triangle - 0.01)) == Verdict::TriangleAngle);
  }
}

TEST_CASE("fidelity: strict asks every pair of normals, loose one") {
  // Each triangle on a cylinder's side has one pair of corners on one straight line: 0° apart, the
  // other pairs 45°, and every corner 22.5° from the triangle.
  const OriginalSurface surface = shapes::surfaceOf(shapes::cylinder(8, 4), shapes::Features::None);
  const WorkingMesh mesh(surface);
  const Vertex v = vertexAt(mesh, {1, 0, 0});
  REQUIRE(v);
  CHECK(judgeStanding(mesh, v, rule(Fidelity::Loose, 20, 23)) == Verdict::Accepted);
  CHECK(judgeStanding(mesh, v, rule(Fidelity::Strict, 20, 23)) == Verdict::VertexAngle);
  CHECK(judgeStanding(mesh, v, rule(Fidelity::Strict, 46, 23)) == Verdict::Accepted);
  CHECK(judgeStanding(mesh, v, rule(Fidelity::Loose, 20, 22)) == Verdict::TriangleAngle);
}

TEST_CASE("fidelity: in the plane a vertex may move within its star and not out of it") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::grid(4, 4));
  const WorkingMesh mesh(surface);
  const Vertex v = vertexAt(mesh, {2, 2, 0});
  for (const Fidelity mode : {Fidelity::Strict, Fidelity::Loose, Fidelity::Fold}) {
    const FidelityRule by = rule(mode, 20, 20);
    CHECK(judgeMove(mesh, v, {2.3, 2.4, 0}, by) == Verdict::Accepted);
    CHECK(judgeMove(mesh, v, {2.9, 2.1, 0}, by) == Verdict::Accepted);
    CHECK(judgeMove(mesh, v, {3.2, 2.1, 0}, by) != Verdict::Accepted);
    CHECK(judgeMove(mesh, v, {3, 2.5, 0}, by) != Verdict::Accepted);  // a triangle without area
  }
}

TEST_CASE("fidelity: a fold that is there may be mended and not made worse") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::grid(4, 4));
  WorkingMesh mesh(surface);
  const Vertex v = vertexAt(mesh, {2, 2, 0});
  Placement folded = mesh.placement(v);
  folded.position = {3.2, 2.1, 0.5};
  mesh.move(v, folded);
  const FidelityRule fold = rule(Fidelity::Fold, 20, 20);
  CHECK(judgeMove(mesh, v, {2.2, 2.1, 0}, fold) == Verdict::Accepted);
  CHECK(judgeMove(mesh, v, {3.2, 2.1, 0.6}, fold) == Verdict::Accepted);
  CHECK(judgeMove(mesh, v, {3.2, 2.1, 0.4}, fold) == Verdict::FoldsOver);
}

TEST_CASE("fidelity: what may lean far may not turn over, even where walls stand around it") {
  // The cap of an L, seen from below, and the flip of a diagonal at its reflex corner, 3.
  TriangleMesh bracket;
  for (const double z : {0, 1})
    for (const Vec2& p : {Vec2(0, 0), Vec2(3, 0), Vec2(3, 1), Vec2(1, 1), Vec2(1, 3), Vec2(0, 3)})
      bracket.positions.emplace_back(p.x(), p.y(), z);
  for (Index i = 2; i < 6; ++i)
    bracket.indices.insert(bracket.indices.end(), {0, i, i - 1, 6, i + 5, i + 6});
  for (Index i = 0; i < 6; ++i) {
    const Index next = (i + 1) % 6;
    bracket.indices.insert(bracket.indices.end(), {i, next, next + 6, i, next + 6, i + 6});
  }
  const OriginalSurface surface = shapes::surfaceOf(bracket);
  const WorkingMesh mesh(surface);
  LocalChange change;
  REQUIRE(proposeFlip(mesh, mesh.mesh().find(Vertex(0), Vertex(3)), change));
  FidelityRule lenient = rule(Fidelity::Fold, 20, 20);
  lenient.fold = -kFold;
  CHECK(judge(mesh, change, lenient) == Verdict::FoldsOver);
}

TEST_CASE("fidelity: no triangle becomes a line, even where normals say nothing") {
  // A square with both its sides is a flat tetrahedron.
  TriangleMesh square;
  square.positions = {{0, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  square.indices = {0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2};
  const OriginalSurface surface = shapes::surfaceOf(square, shapes::Features::None);
  const Quantum kSingle{2 * 0x1p-24};
  for (const double height : {0.0, 1e-9}) {
    CAPTURE(height);
    WorkingMesh mesh(surface);
    const Halfedge bottom = mesh.mesh().find(Vertex(0), Vertex(1));
    Placement middle = mesh.onSurface({HalfedgeMesh::face(bottom), {0.5, 0.5, 0}});
    middle.position = {0.5, 1 + height, 0};
    const Vertex m = mesh.split(bottom, middle).vertex;
    LocalChange change;
    REQUIRE(proposeFlip(mesh, mesh.mesh().find(m, Vertex(3)), change));
    if (height == 0) CHECK(judge(mesh, change, rule(Fidelity::Fold, 20, 20)) != Verdict::Accepted);
    // What double precision tells apart is one line when written in single precision.
    CHECK(flattens(mesh, change, {}) == (height == 0));
    CHECK(flattens(mesh, change, kSingle));
    apply(mesh, change);
    CHECK((smallestGoingAngle(mesh, change) > 0) == (height > 0));
    CHECK(smallestGoingAngle(mesh, change, kSingle) == 0);
    // A line that is there may stay, and go.
    proposePlacement(mesh, m, mesh.placement(m), change);
    CHECK_FALSE(flattens(mesh, change, kSingle));
    REQUIRE(proposeFlip(mesh, mesh.mesh().find(Vertex(0), Vertex(1)), change));
    CHECK_FALSE(flattens(mesh, change, kSingle));
  }
}

TEST_CASE("fidelity: the triangles on both sides of a sharp edge are each measured on their own") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::cube(3));
  const WorkingMesh mesh(surface);
  for (Index v = 0; v < mesh.mesh().vertexCapacity(); ++v)
    CHECK(judgeStanding(mesh, Vertex(v), rule(Fidelity::Strict, 1, 1)) == Verdict::Accepted);
}

TEST_CASE("fidelity: a collapse is judged by what it leaves") {
  // Any collapse inside a plane that the gate accepts leaves every triangle facing up.
  const OriginalSurface surface = shapes::surfaceOf(shapes::grid(5, 5));
  Projector projector(surface, Projection::Patches, 2);
  LocalChange change;
  int accepted = 0;
  for (Index i = 0; i < surface.mesh().halfedgeCapacity(); ++i) {
    WorkingMesh mesh(surface);
    if (!proposeCollapse(mesh, projector, Halfedge(i), change)) continue;
    if (judge(mesh, change, rule(Fidelity::Fold, 20, 20)) != Verdict::Accepted) continue;
    apply(mesh, change);
    ++accepted;
    for (Index f = 0; f < mesh.mesh().faceCapacity(); ++f) {
      if (!mesh.mesh().isAlive(Face(f))) continue;
      const auto [a, b, c] = mesh.mesh().vertices(Face(f));
      CHECK(areaVector(mesh.position(a), mesh.position(b), mesh.position(c)).z() > 0);
    }
  }
  CHECK(accepted > 0);
}
