// SPDX-License-Identifier: MIT
#include "remesh/steps/relax.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "remesh/accuracy/fit.h"
#include "remesh/gate/angles.h"
#include "support/runs.h"

using namespace remesher;

namespace {

// Flips leave something to smooth.
void disturb(shapes::TestRun& test, Index every = 11) {
  for (Index i = 0; i < test.mesh.mesh().halfedgeCapacity(); i += every)
    if (proposeFlip(test.mesh, Halfedge(i), test.run.scratch.change)) commit(test.run);
}

std::vector<Vertex> movedSince(const VertexData<Vec3>& before, const WorkingMesh& mesh) {
  std::vector<Vertex> moved;
  for (Index i = 0; i < before.size(); ++i)
    if (before[Vertex(i)] != mesh.position(Vertex(i))) moved.emplace_back(i);
  return moved;
}

// The smallest angle of each triangle, in degrees, the smallest first.
std::vector<double> anglesOf(const WorkingMesh& mesh) {
  std::vector<double> angles;
  for (Index i = 0; i < mesh.mesh().faceCapacity(); ++i)
    if (mesh.mesh().isAlive(Face(i))) angles.push_back(smallestAngle(mesh, Face(i)) / radians(1));
  std::sort(angles.begin(), angles.end());
  return angles;
}

std::ptrdiff_t countBelow(const std::vector<double>& angles, double limit) {
  return std::lower_bound(angles.begin(), angles.end(), limit) - angles.begin();
}

}  // namespace

TEST_CASE("relax: what lies still stays, and only what has gone far stirs its neighbours") {
  shapes::TestRun test(shapes::icosphere(8));
  disturb(test);
  relax(test.run, 300);
  const VertexData<Vec3> still = test.mesh.positions();
  relax(test.run, 1);
  CHECK(movedSince(still, test.mesh).empty());

  const Vertex v(40);
  test.mesh.stirNeighbors(v, 1e-6 * test.sizes.mean());
  relax(test.run, 1);
  CHECK(movedSince(still, test.mesh).empty());

  test.mesh.stirNeighbors(v, test.sizes.mean());
  relax(test.run, 1);
  const std::vector<Vertex> moved = movedSince(still, test.mesh);
  CHECK_FALSE(moved.empty());
  for (const Vertex one : moved) {
    bool isBeside = false;
    test.mesh.mesh().forEachNeighbor(one, [&](Vertex w) {
      isBeside = isBeside || w == v || std::find(moved.begin(), moved.end(), w) != moved.end();
    });
    CHECK(isBeside);
  }
}

TEST_CASE("relax: a vertex waits until its neighbours' mean has gone by the share asked for") {
  shapes::TestRun test(shapes::icosphere(8));
  disturb(test);
  relax(test.run, 300);
  const VertexData<Vec3> still = test.mesh.positions();
  test.mesh.stirNeighbors(Vertex(40), 6 * 0.04 * test.sizes.mean());
  relax(test.run, 1, 0.05);
  CHECK(movedSince(still, test.mesh).empty());
  relax(test.run, 1, 0.03);
  CHECK_FALSE(movedSince(still, test.mesh).empty());
}

TEST_CASE("relax: smoothing does not undo fitting, but around what changes") {
  shapes::TestRun test(shapes::icosphere(8));
  disturb(test);
  relax(test.run, 2);
  const VertexData<Vec3> smoothed = test.mesh.positions();
  fit(test.run, {});
  const VertexData<Vec3> fitted = test.mesh.positions();
  CHECK_FALSE(movedSince(smoothed, test.mesh).empty());
  relax(test.run, 4);
  CHECK(movedSince(fitted, test.mesh).empty());
  disturb(test);
  relax(test.run, 1);
  CHECK_FALSE(movedSince(fitted, test.mesh).empty());
}

TEST_CASE("relax: few triangles that smoothing leaves below 50° stay so, and none gets worse") {
  shapes::TestRun test(shapes::icosphere(8));
  disturb(test, 97);
  relax(test.run, 300);
  const std::vector<double> before = anglesOf(test.mesh);
  const VertexData<Vec3> smoothed = test.mesh.positions();
  REQUIRE(countBelow(before, 50) > 100);
  widenAngles(test.run);
  const std::vector<double> after = anglesOf(test.mesh);
  CHECK(countBelow(after, 50) < countBelow(before, 50) / 2);
  CHECK(after[0] >= before[0]);
  CHECK(shapes::checkWorkingMesh(test.mesh) == "");
  for (const Vertex v : movedSince(smoothed, test.mesh)) CHECK_FALSE(test.mesh.isPinned(v));
}
