// SPDX-License-Identifier: MIT
#include "mesh/star_passes.h"

#include <doctest/doctest.h>

#include <set>

#include "mesh/euler_operators.h"
#include "mesh/mesh_builder.h"
#include "support/mesh_check.h"
#include "support/shapes.h"

using namespace remesher;

TEST_CASE("star passes: a star loses one vertex per pass, and in the end none may go") {
  HalfedgeMesh mesh = buildMesh(shapes::icosphere(2)).mesh;
  StarPasses passes(mesh);
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

TEST_CASE("star passes: edges in the order of their keys, and no triangle changes twice") {
  HalfedgeMesh mesh = buildMesh(shapes::icosphere(2)).mesh;
  const std::size_t before = mesh.vertexCount(), most = before + 20;
  StarPasses passes(mesh);
  EdgeQueue edges(mesh, [](Halfedge h) { return double(h.index % 7); });
  double last = kInfinity;
  std::set<Face> changed;
  const auto goesOn = [&] {
    CHECK(edges.largestKey() <= last);
    last = edges.largestKey();
    return mesh.vertexCount() < most;
  };
  const std::size_t splits = passes.run(edges, goesOn, [&](Halfedge h) {
    const Face one = HalfedgeMesh::face(h), other = HalfedgeMesh::face(mesh.twin(h));
    CHECK(passes.hasTouchedFace(h) == (changed.contains(one) || changed.contains(other)));
    if (passes.hasTouchedFace(h)) return Vertex();
    const Vertex made = EulerOperators(mesh).split(h).vertex;
    mesh.forEachOutgoing(made, [&](Halfedge out) { changed.insert(HalfedgeMesh::face(out)); });
    return made;
  });
  CHECK(splits == 20);
  CHECK(mesh.vertexCount() == most);
  CHECK(check(mesh).empty());
}
