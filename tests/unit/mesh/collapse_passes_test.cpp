// SPDX-License-Identifier: MIT
#include "mesh/collapse_passes.h"

#include <doctest/doctest.h>

#include <set>

#include "mesh/check.h"
#include "mesh/euler_operators.h"
#include "mesh/mesh_builder.h"
#include "support/shapes.h"

using namespace remesher;

TEST_CASE("collapse passes: a star loses one vertex per pass, and in the end none may go") {
  HalfedgeMesh mesh = buildMesh(shapes::icosphere(2)).mesh;
  CollapsePasses passes(mesh);
  std::set<Vertex> changed;
  const auto intoFirst = [&](Vertex v) {
    CHECK_FALSE(changed.contains(v));
    CHECK_FALSE(passes.isTouched(v));
    Halfedge legal;
    mesh.forEachOutgoing(v, [&](Halfedge h) {
      if (!legal && EulerOperators::canCollapse(mesh, h)) legal = h;
    });
    if (!legal) return Vertex();
    const Vertex into = EulerOperators(mesh).collapse(legal);
    changed.insert(into);
    mesh.forEachNeighbor(into, [&](Vertex w) { changed.insert(w); });
    return into;
  };
  for (std::size_t before = mesh.vertexCount(); passes.run(intoFirst) > 0;) {
    CHECK(mesh.vertexCount() < before);
    before = mesh.vertexCount();
    CHECK(check(mesh).empty());
    changed.clear();
  }
  CHECK(mesh.vertexCount() == 4);
}
