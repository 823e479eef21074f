// SPDX-License-Identifier: MIT
#include "remesh/quads/mesh/quad_check.h"

#include <doctest/doctest.h>

#include "support/quad_sheets.h"
#include "support/surfaces.h"

using namespace remesher;
using shapes::quadSheet;
using shapes::Wraps;

TEST_CASE("quad_check: surfaces made of rows and columns are sound, and of the kind they are") {
  const QuadMesh cube = shapes::quadCube();
  CHECK(check(cube) == "");
  CHECK(kindOf(cube) == SurfaceKind{2, 1, 0});
  const QuadMesh sheet = quadSheet(5, 4, Wraps::No, shapes::flat);
  CHECK(check(sheet) == "");
  CHECK(kindOf(sheet) == SurfaceKind{1, 1, 1});
  const QuadMesh ring = quadSheet(5, 4, Wraps::Around, shapes::flat);
  CHECK(check(ring) == "");
  CHECK(kindOf(ring) == SurfaceKind{0, 1, 2});
  const QuadMesh torus = quadSheet(5, 4, Wraps::BothWays, shapes::flat);
  CHECK(check(torus) == "");
  CHECK(kindOf(torus) == SurfaceKind{0, 1, 0});
}

TEST_CASE("quad_check: the kind of triangles is known from how each shape was made") {
  for (const shapes::Shape& shape : shapes::all()) {
    CAPTURE(shape.name);
    const BuiltMesh built = buildMesh(shape.mesh);
    CHECK(kindOf(built.mesh) == SurfaceKind{shape.chi, shape.components, shape.loops});
  }
}

TEST_CASE("quad_check: each broken law is found") {
  const QuadMesh sound = quadSheet(4, 4, Wraps::No, shapes::flat);
  QuadMesh broken = sound;
  broken.quads[5][2] = broken.quads[5][0];
  CHECK(check(broken) == "a quad has not four corners");
  broken = sound;
  broken.vertices.push_back(broken.vertices.front());
  CHECK(check(broken) == "a vertex is in no quad");
  broken = sound;
  broken.quads.push_back(broken.quads[5]);
  broken.curves.push_back(broken.curves[5]);
  CHECK(check(broken) == "the quads are no manifold");
  broken = sound;
  std::swap(broken.quads[5][1], broken.quads[5][3]);  // turned over
  CHECK(check(broken) == "the quads are no manifold");
  broken = sound;
  broken.curves[5][0] = 0;
  CHECK(check(broken) == "the two sides of an edge are on different curves");
  // Two fans at one vertex: corners across from each other.
  broken = quadSheet(2, 2, Wraps::No, shapes::flat);
  broken.quads = {broken.quads[0], broken.quads[3]};
  broken.curves.resize(2);
  std::vector<Placement> used;
  for (Four<Index>& quad : broken.quads)
    for (Index& v : quad) {
      const bool isMiddle = v == 4;
      if (!isMiddle || used.size() < 4) used.push_back(broken.vertices[v]);
      v = isMiddle ? Index(2) : Index(used.size() - 1);
    }
  broken.vertices = used;
  CHECK(check(broken) == "the quads are no manifold");
}

TEST_CASE("quad_check: two quads that share two sides are found") {
  QuadMesh mesh;
  for (const Vec3& p : {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(2, 2, 0), Vec3(0, 2, 0), Vec3(1, 1, 0)})
    mesh.vertices.push_back(shapes::placed(p));
  mesh.quads = {{0, 1, 2, 4}, {0, 4, 2, 3}};
  mesh.curves.assign(2, {kNone, kNone, kNone, kNone});
  CHECK(check(mesh) == "two quads share two sides");
}
