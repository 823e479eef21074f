// SPDX-License-Identifier: MIT
#include "remesh/schemes/kept_edges.h"

#include <doctest/doctest.h>

#include <cmath>

#include "mesh/mesh_builder.h"
#include "support/shapes.h"

using namespace remesher;

namespace {

// A cube of side 2 about the origin.
TriangleMesh centredCube(int n) {
  TriangleMesh cube = shapes::cube(n);
  for (Vec3& p : cube.positions) p = 2 / double(n) * p - Vec3::Ones();
  return cube;
}

Surface surfaceOf(const BuiltMesh& built) { return {built.mesh, built.positions}; }

}  // namespace

TEST_CASE("kept edges: all are there on a surface divided otherwise, and none on a ball") {
  const BuiltMesh cube = buildMesh(centredCube(3)), finer = buildMesh(centredCube(7));
  const BuiltMesh ball = buildMesh(shapes::icosphere(8));
  CHECK(shareOfSharpEdges(surfaceOf(cube), surfaceOf(finer), 1e-3) == doctest::Approx(1));
  CHECK(shareOfSharpEdges(surfaceOf(cube), surfaceOf(ball), 1e-3) == 0);
  CHECK(shareOfSharpEdges(surfaceOf(ball), surfaceOf(cube), 1e-3) == 1);
}

TEST_CASE("kept edges: an edge that has moved too far is not found, and the others are") {
  const BuiltMesh cube = buildMesh(centredCube(4));
  TriangleMesh moved = centredCube(4);
  for (Vec3& p : moved.positions)
    if (p.x() == 1 && p.y() == 1) p += Vec3(0.2, 0, 0);
  const BuiltMesh other = buildMesh(moved);
  const double share = shareOfSharpEdges(surfaceOf(cube), surfaceOf(other), 0.01);
  CHECK(share > 0.8);
  CHECK(share < 0.95);
}

TEST_CASE("kept edges: rims are as far as their corners and their chords are") {
  const BuiltMesh cube = buildMesh(centredCube(4)), ball = buildMesh(shapes::icosphere(8));
  TriangleMesh moved = centredCube(1);
  moved.positions[0] *= 1.2;
  const BuiltMesh other = buildMesh(moved);
  const MeshTree tree(cube.mesh, cube.positions);
  CHECK(farthestOfRims(surfaceOf(cube), tree) == 0);
  CHECK(farthestOfRims(surfaceOf(ball), tree) == 0);
  CHECK(farthestOfRims(surfaceOf(other), tree) == doctest::Approx(0.2 * std::sqrt(3.0)));
  // A boundary is a rim as well.
  const BuiltMesh square = buildMesh(shapes::grid(3, 3));
  TriangleMesh half;
  for (const Vec3& p : {Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(0, 3, 0)}) shapes::addVertex(half, p);
  shapes::addTriangle(half, 0, 1, 2);
  const BuiltMesh cut = buildMesh(half);
  CHECK(farthestOfRims(surfaceOf(square), MeshTree(cut.mesh, cut.positions)) ==
        doctest::Approx(3 / std::sqrt(2.0)));
}

TEST_CASE("kept edges: the volume grows with the cube of the size, and an open surface has none") {
  const BuiltMesh cube = buildMesh(centredCube(2)), open = buildMesh(shapes::grid(3, 3));
  TriangleMesh larger = centredCube(5);
  for (Vec3& p : larger.positions) p = 1.1 * p + Vec3(3, 4, 5);
  CHECK(changeOfVolume(surfaceOf(cube), surfaceOf(buildMesh(larger))) ==
        doctest::Approx(1.1 * 1.1 * 1.1 - 1));
  CHECK(changeOfVolume(surfaceOf(open), surfaceOf(cube)) == 0);
}

TEST_CASE("kept edges: corners are where sharp edges meet or bend, once at each place") {
  const BuiltMesh cube = buildMesh(centredCube(4)), sheet = buildMesh(shapes::grid(3, 5));
  const BuiltMesh ball = buildMesh(shapes::icosphere(8));
  CHECK(countSharpCorners(surfaceOf(cube)) == 8);
  CHECK(countSharpCorners(surfaceOf(sheet)) == 4);
  CHECK(countSharpCorners(surfaceOf(ball)) == 0);
}
