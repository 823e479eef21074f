// SPDX-License-Identifier: MIT
#include "remesh/steps/apart.h"

#include <doctest/doctest.h>

#include <array>
#include <set>

#include "support/runs.h"

using namespace remesher;

namespace {

constexpr int kCells = 4;
constexpr std::size_t kInside = (kCells - 1) * (kCells - 1), kAll = (kCells + 1) * (kCells + 1);

// Two sheets nearer to each other than single precision tells apart.
TriangleMesh nearSheets(int cells) {
  TriangleMesh below = shapes::grid(cells, cells), above = below;
  for (Vec3& p : below.positions) p.z() = 1;
  for (Vec3& p : above.positions) p.z() = 1 + 1e-10;
  return soups::joined({below, above});
}

std::size_t writtenPlaces(const shapes::TestRun& test) {
  std::set<std::array<float, 3>> places;
  for (Index i = 0; i < test.mesh.mesh().vertexCapacity(); ++i) {
    const Vec3& p = test.mesh.position(Vertex(i));
    places.insert({float(p.x()), float(p.y()), float(p.z())});
  }
  return places.size();
}

std::size_t movedSince(const VertexData<Vec3>& before, const shapes::TestRun& test) {
  std::size_t moved = 0;
  for (Index i = 0; i < before.size(); ++i)
    moved += before[Vertex(i)] != test.mesh.position(Vertex(i));
  return moved;
}

}  // namespace

TEST_CASE("apart: of vertices that are written at one place all but one go, inside of boundaries") {
  constexpr std::size_t kCutCorners = 2;  // of the grid, by edges inside, which lie on each other
  shapes::TestRun test(nearSheets(kCells));
  test.run.asked.rule.quantum.size = 1e-7;
  const VertexData<Vec3> before = test.mesh.positions();
  CHECK(writtenPlaces(test) == kAll);
  CHECK(moveApart(test.run) == 0);
  CHECK(writtenPlaces(test) == kAll + kInside + 2 * kCutCorners);
  CHECK(movedSince(before, test) == kInside + 2 * kCutCorners);
  CHECK(shapes::checkWorkingMesh(test.mesh) == "");
}

TEST_CASE("apart: what is written in full precision stays") {
  shapes::TestRun test(nearSheets(kCells));
  const VertexData<Vec3> before = test.mesh.positions();
  CHECK(moveApart(test.run) == 0);
  CHECK(movedSince(before, test) == 0);
}

TEST_CASE("apart: those that must stay are counted, but for boundaries") {
  // A cube and another that begins where it ends: the corners of the faces that touch.
  TriangleMesh below = shapes::cube(1), above = below;
  for (Vec3& p : above.positions) p.z() += 1 + 1e-10;
  shapes::TestRun test(soups::joined({below, above}));
  test.run.asked.rule.quantum.size = 1e-7;
  CHECK(moveApart(test.run) == 4);
  shapes::TestRun sheets(nearSheets(1));
  sheets.run.asked.rule.quantum.size = 1e-7;
  CHECK(moveApart(sheets.run) == 0);
}

TEST_CASE("apart: a vertex of a boundary leaves the corner of another") {
  TriangleMesh below, above;
  soups::addTriangle(below, {0, 0, 0}, {0, -2, 0}, {2, 0, 0});
  soups::addTriangle(above, {1, 0, 0}, {2, 1, 0}, {0, 1, 0});
  shapes::TestRun test(soups::joined({below, above}));
  const Halfedge side = test.mesh.mesh().find(Vertex(2), Vertex(0));
  REQUIRE(proposeSplit(test.mesh, test.projector, side, test.run.scratch.change));
  REQUIRE(commit(test.run));
  const Vec3 corner = test.mesh.position(Vertex(3));
  REQUIRE(test.mesh.position(test.run.scratch.result) == corner);
  const Vertex middle = test.run.scratch.result;
  CHECK(moveApart(test.run) == 0);
  CHECK(test.mesh.position(Vertex(3)) == corner);
  CHECK((test.mesh.position(middle) - corner).norm() > 0.1);
  CHECK(test.mesh.position(middle).y() == 0);
  CHECK(shapes::checkWorkingMesh(test.mesh) == "");
}
