// SPDX-License-Identifier: MIT
#include "original/patches/disk_patch.h"

#include <doctest/doctest.h>

#include "support/surfaces.h"

using namespace remesher;
using surfaces::Surface;

namespace {

// As much of the mesh as stays a disk, breadth first from one face.
void growAll(DiskGrower& grower, Face start) {
  grower.clear();
  grower.add(start);
  for (std::size_t head = 0; head < grower.faces().size(); ++head) {
    for (int i = 0; i < 3; ++i) {
      const Face g = grower.neighbor(HalfedgeMesh::halfedge(grower.faces()[head], i));
      if (g) grower.add(g);
    }
  }
}

// Every n-th face is left out, so that holes, tails and ears appear.
void growWithGaps(DiskGrower& grower, Index faceCount, Index n) {
  grower.clear();
  for (Index f = 0; f < faceCount; ++f)
    if (f % n != n - 1) grower.add(Face(f));
}

std::size_t sides(const DiskPatch& patch, bool (*counts)(LocalIndex)) {
  std::size_t count = 0;
  for (const LocalFace& f : patch.faces)
    for (const LocalIndex g : f.across) count += counts(g) ? 1 : 0;
  return count;
}

// Everything a disk is: χ = 1 and a rim that meets each of its vertices once and all its sides.
void checkIsDisk(const DiskPatch* patch) {
  REQUIRE(patch);
  const std::size_t rim = sides(*patch, [](LocalIndex g) { return g == kNoLocal; });
  const std::size_t inner = sides(*patch, [](LocalIndex g) { return g != kNoLocal; }) / 2;
  CHECK(int(patch->vertices.size()) - int(inner + rim) + int(patch->faces.size()) == 1);
  CHECK(patch->rim.size() == rim);
  std::vector<int> met(patch->vertices.size(), 0);
  for (const LocalIndex v : patch->rim) CHECK(++met[v] == 1);
}

// A face joined to the patch by one side whose other sides are not both closed for ever.
bool isEar(const DiskGrower& grower, const LocalFace& f) {
  int held = 0, free = 0;
  for (int i = 0; i < 3; ++i) {
    held += f.across[std::size_t(i)] != kNoLocal ? 1 : 0;
    const Face g = grower.neighbor(HalfedgeMesh::halfedge(Face(f.face), i));
    free += g && !grower.holds(g) ? 1 : 0;
  }
  return held == 1 && free > 0;
}

}  // namespace

TEST_CASE("disk_patch: a fan closes around its middle") {
  const HalfedgeMesh fan(7,
                         std::vector<Index>{0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5, 0, 5, 6, 0, 6, 1});
  DiskGrower grower(fan, {});
  CHECK(grower.add(Face(0)));
  CHECK_FALSE(grower.add(Face(3)));  // meets the patch in a vertex only
  for (const Index f : {1u, 2u, 3u, 4u}) CHECK(grower.add(Face(f)));
  CHECK_FALSE(grower.add(Face(3)));  // held already
  CHECK(grower.add(Face(5)));        // two sides
  checkIsDisk(grower.cut());
  CHECK(grower.cut()->rim.size() == 6);
}

TEST_CASE("disk_patch: refuses the face that would close a ring, as in the report's Figure 2") {
  // A strip of six faces bent into a ring. Face 4 has one neighbour in the patch, and its opposite
  // vertex is held; so has face 5 from the other end.
  const HalfedgeMesh ring(6,
                          std::vector<Index>{0, 1, 3, 1, 4, 3, 1, 2, 4, 2, 5, 4, 2, 0, 5, 0, 3, 5});
  DiskGrower grower(ring, {});
  for (Index f = 0; f < 4; ++f) CHECK(grower.add(Face(f)));
  CHECK_FALSE(grower.add(Face(4)));
  CHECK_FALSE(grower.add(Face(5)));
  checkIsDisk(grower.cut());
}

TEST_CASE("disk_patch: from every start on every surface a disk grows, before and after trimming") {
  for (const Surface& surface : surfaces::all()) {
    CAPTURE(surface.name);
    DiskGrower grower(surface.mesh(), {});
    for (Index f = 0; f < surface.mesh().faceCapacity(); f += 11) {
      growAll(grower, Face(f));
      checkIsDisk(grower.cut());
      const Face kept[] = {Face(f)};
      grower.trimEars(kept);
      CHECK(grower.holds(Face(f)));
      checkIsDisk(grower.cut());
    }
  }
}

TEST_CASE("disk_patch: a closed surface of genus 0 is held but for one face, never whole") {
  for (const TriangleMesh& mesh :
       {shapes::tetrahedron(), shapes::cube(1), shapes::icosphere(7), shapes::cone(9)}) {
    const Surface surface = surfaces::surface("", mesh);
    DiskGrower grower(surface.mesh(), {});
    growAll(grower, Face(0));
    CHECK(grower.faces().size() == surface.mesh().faceCount() - 1);
    CHECK(grower.cut()->rim.size() == 3);
  }
}

TEST_CASE("disk_patch: trimming leaves no ear") {
  for (const Surface& surface : surfaces::all()) {
    CAPTURE(surface.name);
    DiskGrower grower(surface.mesh(), {});
    for (const Index n : {3u, 4u, 5u, 7u}) {
      growWithGaps(grower, Index(surface.mesh().faceCapacity()), n);
      checkIsDisk(grower.cut());
      const Face kept[] = {grower.faces()[0]};
      grower.trimEars(kept);
      const DiskPatch* patch = grower.cut();
      checkIsDisk(patch);
      for (const LocalFace& f : patch->faces) CHECK((f.face == kept[0].index || !isEar(grower, f)));
    }
  }
}

TEST_CASE("disk_patch: a barrier across a plane halves it") {
  const Surface plane = surfaces::surface("", shapes::grid(6, 6));
  const auto barriers = barriersBetween(plane, [](const Vec3& p) { return p.y() == 3; });
  DiskGrower grower(plane.mesh(), barriers.values());
  growAll(grower, Face(0));
  CHECK(grower.faces().size() == plane.mesh().faceCount() / 2);
  checkIsDisk(grower.cut());
}

TEST_CASE("disk_patch: around the end of a barrier the patch does not meet itself") {
  const Surface plane = surfaces::surface("", shapes::grid(6, 6));
  const auto slit = barriersBetween(plane, [](const Vec3& p) { return p.y() == 3 && p.x() <= 3; });
  DiskGrower grower(plane.mesh(), slit.values());
  for (Index f = 0; f < plane.mesh().faceCapacity(); ++f) {
    growAll(grower, Face(f));
    checkIsDisk(grower.cut());
    for (Index i = 0; i < plane.mesh().halfedgeCapacity(); ++i) {
      if (!slit[Halfedge(i)]) continue;
      const Halfedge t = plane.mesh().twin(Halfedge(i));
      CHECK_FALSE(
          (grower.holds(HalfedgeMesh::face(Halfedge(i))) && grower.holds(HalfedgeMesh::face(t))));
    }
  }
}
