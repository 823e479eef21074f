// SPDX-License-Identifier: MIT
#include "surface/disk_patch.h"

#include <doctest/doctest.h>

#include "support/patch_shapes.h"

using namespace remesher;
using namespace remesher::patch_shapes;

namespace {

// The whole mesh, or as much of it as stays a disk, breadth first from one face.
void growAll(const HalfedgeMesh& mesh, DiskGrower& grower, Face start) {
  grower.clear();
  grower.add(start);
  for (std::size_t head = 0; head < grower.faces().size(); ++head) {
    for (int i = 0; i < 3; ++i) {
      const Face g = grower.neighbor(HalfedgeMesh::halfedge(grower.faces()[head], i));
      if (g) grower.add(g);
    }
  }
  CHECK(mesh.isAlive(start));
}

int eulerCharacteristic(const DiskPatch& patch) {
  std::size_t halves = 0, rim = 0;
  for (const LocalFace& f : patch.faces)
    for (const LocalIndex g : f.across) ++(g == kNoLocal ? rim : halves);
  return int(patch.vertices.size()) - int(halves / 2 + rim) + int(patch.faces.size());
}

}  // namespace

TEST_CASE("disk_patch: refuses the face that would close a ring, as in the report's Figure 2") {
  // The six faces around vertex 0; with faces 0, 1, 2, 3 and 4 held, every vertex is held too.
  const HalfedgeMesh fan(7,
                         std::vector<Index>{0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5, 0, 5, 6, 0, 6, 1});
  DiskGrower grower(fan, {});
  CHECK(grower.add(Face(0)));
  CHECK_FALSE(grower.add(Face(3)));  // meets the patch in a vertex only
  CHECK(grower.add(Face(1)));
  CHECK(grower.add(Face(2)));
  CHECK(grower.add(Face(3)));
  CHECK_FALSE(grower.add(Face(3)));  // held already
  CHECK(grower.add(Face(4)));
  CHECK(grower.add(Face(5)));  // two sides: the fan closes around vertex 0
  REQUIRE(grower.cut());
  CHECK(grower.cut()->rim.size() == 6);

  // A strip of six faces bent into a ring: the last face has one neighbour in the patch, and its
  // opposite vertex is held.
  const HalfedgeMesh ring(6,
                          std::vector<Index>{0, 1, 3, 1, 4, 3, 1, 2, 4, 2, 5, 4, 2, 0, 5, 0, 3, 5});
  DiskGrower around(ring, {});
  for (Index f = 0; f < 4; ++f) CHECK(around.add(Face(f)));
  CHECK_FALSE(around.add(Face(4)));
  CHECK_FALSE(around.add(Face(5)));
}

TEST_CASE("disk_patch: a closed surface is never held whole") {
  for (const Shape& shape : closedShapes()) {
    CAPTURE(shape.name);
    DiskGrower grower(shape.mesh, {});
    growAll(shape.mesh, grower, Face(0));
    CHECK(grower.faces().size() < shape.mesh.faceCount());
    const DiskPatch* patch = grower.cut();
    REQUIRE(patch);
    CHECK(eulerCharacteristic(*patch) == 1);
  }
}

TEST_CASE("disk_patch: a sphere without one face is a disk with a rim of three") {
  const Shape sphere = icosphere(2);
  DiskGrower grower(sphere.mesh, {});
  growAll(sphere.mesh, grower, Face(5));
  CHECK(grower.faces().size() == sphere.mesh.faceCount() - 1);
  CHECK(grower.cut()->rim.size() == 3);
}

TEST_CASE("disk_patch: from every start on every shape a disk grows, before and after trimming") {
  for (const Shape& shape : allShapes()) {
    CAPTURE(shape.name);
    DiskGrower grower(shape.mesh, {});
    for (Index f = 0; f < shape.mesh.faceCapacity(); f += 7) {
      growAll(shape.mesh, grower, Face(f));
      CHECK(eulerCharacteristic(*grower.cut()) == 1);
      const Face kept[] = {Face(f)};
      grower.trimEars(kept);
      CHECK(grower.holds(Face(f)));
      const DiskPatch* patch = grower.cut();
      REQUIRE(patch);
      CHECK(eulerCharacteristic(*patch) == 1);
    }
  }
}

TEST_CASE("disk_patch: trimming leaves no ear but the kept and those cut off on both sides") {
  const Shape plane = grid(8);
  DiskGrower grower(plane.mesh, {});
  grower.add(Face(0));
  // A few faces in a row, so that ears and tails of ears appear.
  for (Index f = 0; f < plane.mesh.faceCapacity(); f += 1)
    if (f % 5 != 3) grower.add(Face(f));
  grower.trimEars({});
  const DiskPatch* patch = grower.cut();
  REQUIRE(patch);
  for (const LocalFace& f : patch->faces) {
    int held = 0, open = 0;
    for (int i = 0; i < 3; ++i) {
      if (f.across[i] != kNoLocal) ++held;
      if (f.across[i] == kNoLocal && grower.neighbor(HalfedgeMesh::halfedge(Face(f.face), i)))
        ++open;
    }
    CHECK_FALSE((held == 1 && open > 0));
  }
}

TEST_CASE("disk_patch: never crosses a barrier") {
  const Shape plane = grid(6);
  // The grid's middle row of edges is closed: vertices with y = 3.
  HalfedgeData<char> barriers(plane.mesh.halfedgeCapacity(), 0);
  for (Index i = 0; i < plane.mesh.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    barriers[h] = plane.positions[plane.mesh.origin(h)].y() == 3 &&
                  plane.positions[plane.mesh.tip(h)].y() == 3;
  }
  DiskGrower grower(plane.mesh, barriers.values());
  growAll(plane.mesh, grower, Face(0));
  CHECK(grower.faces().size() == plane.mesh.faceCount() / 2);
  REQUIRE(grower.cut());

  // A barrier that ends inside: around its end, the last face would meet itself across it.
  HalfedgeData<char> slit(plane.mesh.halfedgeCapacity(), 0);
  for (Index i = 0; i < plane.mesh.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    const Vec3 &a = plane.positions[plane.mesh.origin(h)], &b = plane.positions[plane.mesh.tip(h)];
    slit[h] = a.y() == 3 && b.y() == 3 && a.x() <= 3 && b.x() <= 3;
  }
  DiskGrower around(plane.mesh, slit.values());
  growAll(plane.mesh, around, Face(0));
  const DiskPatch* patch = around.cut();
  REQUIRE(patch);
  CHECK(eulerCharacteristic(*patch) == 1);
}
