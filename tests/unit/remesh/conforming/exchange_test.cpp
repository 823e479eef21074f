// SPDX-License-Identifier: MIT
#include "remesh/conforming/exchange.h"

#include <doctest/doctest.h>

#include <cmath>

#include "mesh/mesh_builder.h"
#include "remesh/conforming/refinement.h"
#include "remesh/conforming/smoothing_facets.h"
#include "remesh/conforming/thinning.h"
#include "support/mesh_check.h"
#include "support/parts.h"
#include "support/shapes.h"

using namespace remesher;

namespace {

struct Found {
  double mean = 0, least = 180;
};

Found anglesIn(const FacetedMesh& mesh) {
  Found found;
  const HalfedgeMesh& m = mesh.mesh();
  for (Index i = 0; i < m.faceCapacity(); ++i) {
    if (!m.isAlive(Face(i))) continue;
    const auto [a, b, c] = m.vertices(Face(i));
    const Index facet = mesh.facet(Face(i));
    const double angle =
        degrees(smallestFlatAngle(mesh.flat(a, facet), mesh.flat(b, facet), mesh.flat(c, facet)));
    found.mean += angle / double(m.faceCount());
    found.least = std::min(found.least, angle);
  }
  return found;
}

}  // namespace

TEST_CASE("exchange: vertices go where angles are narrow, and none of the part's own") {
  struct Case {
    TriangleMesh part;
    double times, wider;
  };
  for (const Case& wanted :
       {Case{shapes::drilledPlate(6, 0.5), 7, 0.5}, Case{shapes::drilledPlate(10, 0.5), 7, 0.3}}) {
    const BuiltMesh built = buildMesh(wanted.part);
    const HalfedgeData<char> seams(built.mesh.halfedgeCapacity(), 0);
    auto mesh = std::make_unique<FacetedMesh>(built, seams);
    thinOut(*mesh);
    const auto vertices = std::size_t(wanted.times * double(built.mesh.vertexCount()));
    REQUIRE(refineFacets(*mesh, vertices - mesh->mesh().vertexCount()));
    smoothFacets(*mesh);
    const Found before = anglesIn(*mesh);
    mesh = exchangeVertices(std::move(mesh));
    const Found after = anglesIn(*mesh);
    CHECK(check(mesh->mesh()) == "");
    CHECK(mesh->mesh().vertexCount() == vertices);
    CHECK(mesh->isSound());
    CHECK(after.mean > before.mean + wanted.wider);
    CHECK(after.least >= std::min(before.least, 20.0));
    for (Index i = 0; i < built.mesh.vertexCapacity(); ++i) {
      const Vertex v(i);
      if (mesh->role(v) != FacetRole::Corner) continue;
      CHECK(mesh->mesh().isAlive(v));
      CHECK(mesh->positions()[v] == built.positions[v]);
    }
  }
}

TEST_CASE("exchange: what is wide enough stays as it is") {
  const BuiltMesh built = buildMesh(shapes::boxWithHole());
  const HalfedgeData<char> seams(built.mesh.halfedgeCapacity(), 0);
  auto mesh = std::make_unique<FacetedMesh>(built, seams);
  REQUIRE(refineFacets(*mesh, 6 * built.mesh.vertexCount()));
  smoothFacets(*mesh);
  const FacetedMesh* const before = mesh.get();
  mesh = exchangeVertices(std::move(mesh));
  CHECK(mesh.get() == before);
}
