// SPDX-License-Identifier: MIT
#include "mesh/halfedge_mesh.h"

#include <doctest/doctest.h>

#include <set>

#include "mesh/euler_operators.h"
#include "mesh/mesh_builder.h"
#include "mesh/topology.h"
#include "support/mesh_check.h"
#include "support/shapes.h"

using namespace remesher;

TEST_CASE("halfedge_mesh: two triangles share one edge and keep four on the boundary") {
  const std::vector<Index> square = {0, 1, 2, 0, 2, 3};
  const HalfedgeMesh mesh(4, square);
  int boundary = 0;
  for (Index h = 0; h < mesh.halfedgeCapacity(); ++h) boundary += mesh.isBoundary(Halfedge(h));
  CHECK(boundary == 4);
  CHECK(mesh.triangles() == square);
}

TEST_CASE("halfedge_mesh: known twins make the mesh that found ones make") {
  for (const shapes::Shape& shape : shapes::all()) {
    CAPTURE(shape.name);
    const HalfedgeMesh found = buildMesh(shape.mesh).mesh;
    std::vector<Index> twins;
    for (Index i = 0; i < found.halfedgeCapacity(); ++i)
      twins.push_back(found.twin(Halfedge(i)).index);
    const HalfedgeMesh known(found.vertexCapacity(), found.triangles(), twins);
    CHECK(check(known) == "");
    for (Index i = 0; i < found.halfedgeCapacity(); ++i)
      CHECK(known.twin(Halfedge(i)) == found.twin(Halfedge(i)));
    for (Index v = 0; v < found.vertexCapacity(); ++v)
      CHECK(known.outgoing(Vertex(v)) == found.outgoing(Vertex(v)));
  }
}

TEST_CASE("halfedge_mesh: next and prev turn around a face, twins are an involution") {
  for (const shapes::Shape& shape : shapes::all()) {
    CAPTURE(shape.name);
    const HalfedgeMesh mesh = buildMesh(shape.mesh).mesh;
    for (Index i = 0; i < mesh.halfedgeCapacity(); ++i) {
      const Halfedge h(i);
      CHECK(mesh.next(mesh.next(h)) == mesh.prev(h));
      CHECK(mesh.next(mesh.prev(h)) == h);
      CHECK(mesh.face(mesh.next(h)) == mesh.face(h));
      CHECK(mesh.tip(h) == mesh.origin(mesh.next(h)));
      CHECK(mesh.opposite(h) == mesh.origin(mesh.prev(h)));
      if (mesh.isBoundary(h)) continue;
      CHECK(mesh.twin(mesh.twin(h)) == h);
      CHECK(mesh.origin(mesh.twin(h)) == mesh.tip(h));
      CHECK(mesh.isEdge(h) != mesh.isEdge(mesh.twin(h)));
    }
  }
}

TEST_CASE("halfedge_mesh: a turn around a vertex meets each face and each neighbour once") {
  for (const shapes::Shape& shape : shapes::all()) {
    CAPTURE(shape.name);
    const HalfedgeMesh mesh = buildMesh(shape.mesh).mesh;
    std::size_t faces = 0, neighbors = 0;
    for (Index i = 0; i < mesh.vertexCapacity(); ++i) {
      const Vertex v(i);
      std::set<Vertex> distinct;
      int leaving = 0;
      mesh.forEachOutgoing(v, [&](Halfedge h) {
        CHECK(mesh.origin(h) == v);
        ++leaving;
      });
      mesh.forEachNeighbor(v, [&](Vertex n) {
        distinct.insert(n);
        CHECK(mesh.adjacent(v, n));
        CHECK(mesh.adjacent(n, v));
      });
      CHECK(int(distinct.size()) == mesh.valence(v));
      CHECK(mesh.valence(v) == leaving + mesh.isBoundary(v));
      for (int than = 2; than < 12; ++than)
        CHECK(mesh.hasMoreNeighbors(v, than) == (mesh.valence(v) > than));
      faces += std::size_t(leaving);
      neighbors += distinct.size();
    }
    CHECK(faces == 3 * mesh.faceCount());
    CHECK(neighbors == 2 * edgeCount(mesh));
  }
}

TEST_CASE("halfedge_mesh: find names the halfedge from one vertex to another, or none") {
  const HalfedgeMesh mesh = buildMesh(shapes::grid(3, 3)).mesh;
  for (Index i = 0; i < mesh.vertexCapacity(); ++i)
    for (Index k = 0; k < mesh.vertexCapacity(); ++k) {
      Halfedge expected;
      for (Index j = 0; j < mesh.halfedgeCapacity(); ++j) {
        const Halfedge h(j);
        if (mesh.origin(h) == Vertex(i) && mesh.tip(h) == Vertex(k)) expected = h;
      }
      CHECK(mesh.find(Vertex(i), Vertex(k)) == expected);
    }
}

TEST_CASE("halfedge_mesh: a boundary is walked by the outgoing halfedges") {
  const HalfedgeMesh mesh = buildMesh(shapes::grid(5, 4)).mesh;
  Halfedge first(0);
  while (!mesh.isBoundary(first)) first = Halfedge(first.index + 1);
  int length = 0;
  Halfedge h = first;
  do {
    CHECK(mesh.isBoundary(h));
    h = mesh.outgoing(mesh.tip(h));
    ++length;
  } while (h != first);
  CHECK(length == 2 * (5 + 4));
}

TEST_CASE("halfedge_mesh: vertices without a face are dead and their places used again") {
  HalfedgeMesh mesh(5, std::vector<Index>{0, 2, 4});
  CHECK(mesh.vertexCount() == 3);
  CHECK_FALSE(mesh.isAlive(Vertex(1)));
  CHECK(check(mesh) == "");
  EulerOperators(mesh).split(Halfedge(0));
  CHECK(mesh.vertexCapacity() == 5);
  CHECK(mesh.vertexCount() == 4);
  CHECK(check(mesh) == "");
}

TEST_CASE("halfedge_mesh: compact closes the holes and changes nothing else") {
  HalfedgeMesh mesh = buildMesh(shapes::icosphere(4)).mesh;
  for (Index i = 0; i < mesh.halfedgeCapacity(); i += 7)
    if (mesh.isAlive(Halfedge(i)) && EulerOperators::canCollapse(mesh, Halfedge(i)))
      EulerOperators(mesh).collapse(Halfedge(i));
  const HalfedgeMesh before = mesh;
  REQUIRE(before.vertexCount() < before.vertexCapacity());

  const HalfedgeMesh::Renumbering map = mesh.compact();
  CHECK(check(mesh) == "");
  CHECK(mesh.vertexCapacity() == before.vertexCount());
  CHECK(mesh.faceCapacity() == before.faceCount());
  Index lastFace = 0;
  for (Index f = 0; f < before.faceCapacity(); ++f) {
    if (!before.isAlive(Face(f))) {
      CHECK(map.face[f] == kNone);
      continue;
    }
    CHECK(map.face[f] >= lastFace);
    lastFace = map.face[f];
    for (std::size_t c = 0; c < 3; ++c)
      CHECK(mesh.vertices(Face(map.face[f]))[c].index ==
            map.vertex[before.vertices(Face(f))[c].index]);
  }
}
