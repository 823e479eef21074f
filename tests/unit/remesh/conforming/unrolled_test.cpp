// SPDX-License-Identifier: MIT
#include "remesh/conforming/unrolled.h"

#include <doctest/doctest.h>

#include <cmath>
#include <map>

#include "geometry/triangle.h"
#include "mesh/mesh_builder.h"
#include "original/curves/facets.h"
#include "support/parts.h"

using namespace remesher;

namespace {

struct Part {
  BuiltMesh built;
  FaceData<Index> facets;

  explicit Part(const TriangleMesh& mesh)
      : built(buildMesh(mesh)), facets(findFacets(built.mesh, built.positions, 1e-6)) {
    Index next = 0;
    for (Index i = 0; i < facets.size(); ++i)
      if (facets[Face(i)] != kNone) next = std::max(next, facets[Face(i)] + 1);
    for (Index i = 0; i < facets.size(); ++i)
      if (facets[Face(i)] == kNone) facets[Face(i)] = next++;
  }

  Unrolled unrolled(double depth, const HalfedgeData<char>& fixed) const {
    return unrollFacets(built.mesh, built.positions, facets, fixed, depth, 1e-6);
  }
  Unrolled unrolled(double depth) const {
    return unrolled(depth, HalfedgeData<char>(built.mesh.halfedgeCapacity(), 0));
  }
  Vec3 normal(Face f) const {
    const auto [a, b, c] = built.mesh.vertices(f);
    return unitNormal(built.positions[a], built.positions[b], built.positions[c]);
  }
};

// A cone's shell between two rings, and a shell whose rings lie above each other.
TriangleMesh shell(int sides, double top) {
  TriangleMesh mesh;
  shapes::addSheet(mesh, sides, 1, [&](int column, int row) {
    const Vec3 p = shapes::onCircle(column, sides);
    const double radius = row == 0 ? 1 : top;
    return Vec3(radius * p.x(), radius * p.y(), 2 * row);
  });
  return mesh;
}

}  // namespace

TEST_CASE("unrolled: lengths are those in space, and each vertex is in one place of a region") {
  for (const TriangleMesh& mesh : {shell(48, 1), shell(48, 0.5), shapes::filletedBar(12)}) {
    const Part part(mesh);
    const Unrolled unrolled = part.unrolled(0.01);
    std::map<std::pair<Index, Index>, Vec2> places;
    for (Index i = 0; i < part.facets.size(); ++i) {
      const auto vertices = part.built.mesh.vertices(Face(i));
      const auto& at = unrolled.corners[Face(i)];
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 side =
            part.built.positions[vertices[(k + 1) % 3]] - part.built.positions[vertices[k]];
        CHECK((at[(k + 1) % 3] - at[k]).norm() == doctest::Approx(side.norm()));
        const auto key = std::pair(unrolled.regionOf[Face(i)], vertices[k].index);
        CHECK(places.try_emplace(key, at[k]).first->second == at[k]);
      }
      CHECK(cross(at[1] - at[0], at[2] - at[0]) > 0);
    }
  }
}

TEST_CASE("unrolled: a ring falls into even parts of less than half a turn") {
  for (const int sides : {36, 48, 63, 64, 100}) {
    CAPTURE(sides);
    const Part part(shell(sides, 1));
    const Unrolled unrolled = part.unrolled(0.02);
    std::vector<int> facets(unrolled.isBent.size(), 0);
    for (Index i = 0; i < part.facets.size(); ++i) ++facets[unrolled.regionOf[Face(i)]];
    for (const int triangles : facets) {
      CHECK(triangles >= 2 * sides / 16);
      CHECK(triangles < 2 * (sides / 2));
    }
  }
}

TEST_CASE("unrolled: lines that bend too much, are fixed, or part wide facets stay") {
  const Part bar(shapes::filletedBar(8));
  const auto regions = [](const Unrolled& unrolled) { return unrolled.isBent.size(); };
  const std::size_t facets = regions(bar.unrolled(0));
  CHECK(regions(bar.unrolled(1e-4)) == facets);
  const Unrolled unrolled = bar.unrolled(0.01);
  CHECK(regions(unrolled) == facets - 2 * 7);
  for (Index i = 0; i < bar.built.mesh.halfedgeCapacity(); ++i) {
    const Face f = HalfedgeMesh::face(Halfedge(i)),
               g = HalfedgeMesh::face(bar.built.mesh.twin(Halfedge(i)));
    if (bar.normal(f).dot(bar.normal(g)) < std::cos(radians(40)))
      CHECK(unrolled.regionOf[f] != unrolled.regionOf[g]);
  }
  const HalfedgeData<char> all(bar.built.mesh.halfedgeCapacity(), 1);
  CHECK(regions(bar.unrolled(0.01, all)) == facets);
}
