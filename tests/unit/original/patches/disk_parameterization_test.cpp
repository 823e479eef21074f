// SPDX-License-Identifier: MIT
#include "original/patches/disk_parameterization.h"

#include <doctest/doctest.h>

#include "support/surfaces.h"

using namespace remesher;
using surfaces::Surface;

namespace {

const DiskPatch* growAll(DiskGrower& grower, Face start, std::size_t limit) {
  grower.clear();
  grower.add(start);
  for (std::size_t head = 0; head < grower.faces().size() && grower.faces().size() < limit; ++head)
    for (int i = 0; i < 3; ++i) {
      const Face g = grower.neighbor(HalfedgeMesh::halfedge(grower.faces()[head], i));
      if (g) grower.add(g);
    }
  return grower.cut();
}

// The flat grid whose rim is moved onto the circle as the parameterizer will do it: a map that
// keeps every vertex where it is satisfies the mean value equations.
Surface flatDisk(int n) {
  TriangleMesh mesh;
  shapes::addVertex(mesh, {0, 0, 0});
  for (int ring = 1; ring <= n; ++ring)
    for (int k = 0; k < 12; ++k) shapes::addVertex(mesh, shapes::onCircle(k, 12) * ring / n);
  for (Index k = 0; k < 12; ++k) {
    const Index l = (k + 1) % 12;
    shapes::addTriangle(mesh, 0, 1 + k, 1 + l);
    for (Index ring = 0; ring + 1 < Index(n); ++ring) {
      const Index a = 1 + 12 * ring + k, b = 1 + 12 * ring + l, c = a + 12, d = b + 12;
      shapes::addTriangle(mesh, a, c, d);
      shapes::addTriangle(mesh, a, d, b);
    }
  }
  return surfaces::surface("flat disk", mesh);
}

}  // namespace

TEST_CASE("disk_parameterization: every face of every patch keeps its orientation") {
  for (const Surface& surface : surfaces::all()) {
    CAPTURE(surface.name);
    DiskGrower grower(surface.mesh(), {});
    DiskParameterizer parameterizer;
    for (Index f = 0; f < surface.mesh().faceCapacity(); f += 17) {
      for (const std::size_t limit : {1u, 2u, 10u, 50u, 150u}) {
        const DiskPatch* patch = growAll(grower, Face(f), limit);
        REQUIRE(patch);
        const auto uv = parameterizer.solve(*patch, surface.positions());
        REQUIRE(uv.size() == patch->vertices.size());
        for (const LocalFace& face : patch->faces)
          CHECK(orientation(uv[face.corners[0]], uv[face.corners[1]], uv[face.corners[2]]) > 0);
      }
    }
  }
}

TEST_CASE("disk_parameterization: the rim lies on the circle, at distances by arc length") {
  const Surface plane = surfaces::surface("", shapes::grid(5, 3));
  DiskGrower grower(plane.mesh(), {});
  const DiskPatch* patch = growAll(grower, Face(0), 1000);
  DiskParameterizer parameterizer;
  const auto uv = parameterizer.solve(*patch, plane.positions());
  // All 16 sides of the rim are equally long.
  REQUIRE(patch->rim.size() == 16);
  const double step = 2 * std::sin(std::numbers::pi / 16);
  for (std::size_t i = 0; i < 16; ++i) {
    const Uv a = uv[patch->rim[i]], b = uv[patch->rim[(i + 1) % 16]];
    CHECK(a.norm() == doctest::Approx(1));
    CHECK((b - a).norm() == doctest::Approx(step));
  }
}

TEST_CASE("disk_parameterization: mean value weights leave a flat disk as it is") {
  const Surface disk = flatDisk(5);
  DiskGrower grower(disk.mesh(), {});
  const DiskPatch* patch = growAll(grower, Face(0), 1000);
  REQUIRE(patch->faces.size() == disk.mesh().faceCount());
  DiskParameterizer parameterizer;
  const auto uv = parameterizer.solve(*patch, disk.positions());
  // But for a rotation: distances from the centre and between any two vertices are kept.
  for (std::size_t v = 0; v < uv.size(); ++v)
    for (std::size_t w = 0; w < v; ++w) {
      const double flat =
          (disk.positions()[patch->vertices[v]] - disk.positions()[patch->vertices[w]]).norm();
      CHECK((uv[v] - uv[w]).norm() == doctest::Approx(flat).epsilon(1e-4));
    }
}

TEST_CASE("disk_parameterization: degenerate faces do not break the map") {
  // A grid with whole columns of faces squeezed to nothing, and one with all vertices in one place.
  for (const double width : {1e-3, 1e-9, 0.0}) {
    TriangleMesh mesh = shapes::grid(9, 9);
    Surface plane = surfaces::surface("", mesh);
    for (Vec3& p : plane.built.positions.values())
      p.x() = p.x() < 4 ? p.x() : 3 + (p.x() - 3) * width;
    DiskGrower grower(plane.mesh(), {});
    DiskParameterizer parameterizer;
    const DiskPatch* patch = growAll(grower, Face(0), 1000);
    CHECK_FALSE(parameterizer.solve(*patch, plane.positions()).empty());
    for (Vec3& p : plane.built.positions.values()) p *= width * width;
    CHECK_FALSE(parameterizer.solve(*patch, plane.positions()).empty());
  }
}
