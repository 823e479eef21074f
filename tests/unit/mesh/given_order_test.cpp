// SPDX-License-Identifier: MIT
#include "mesh/given_order.h"

#include <doctest/doctest.h>

#include <cstdint>

#include "support/shapes.h"

using namespace remesher;

namespace {

// A value of its own for each vertex, and a group for each triangle.
TriangleMesh marked(TriangleMesh mesh) {
  mesh.attributes.push_back({"_KIND", 1, {}});
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    mesh.attributes[0].values.push_back(float(v % 7));
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t) mesh.groups.push_back(Index(t % 3));
  return mesh;
}

void checkSame(const TriangleMesh& one, const TriangleMesh& other) {
  CHECK(one.positions == other.positions);
  CHECK(one.indices == other.indices);
  CHECK(one.groups == other.groups);
  for (std::size_t a = 0; a < one.attributes.size(); ++a)
    CHECK(one.attributes[a].values == other.attributes[a].values);
}

}  // namespace

TEST_CASE("given_order: what nothing changed is as it was given") {
  for (const TriangleMesh& mesh : {marked(shapes::torus(12, 6)), marked(shapes::cube(3))})
    checkSame(inGivenOrder(inCanonicalOrder(mesh), mesh), mesh);
}

TEST_CASE("given_order: quads begin at the corner that they were given with, turned over too") {
  TriangleMesh quads = shapes::grid(5, 4);
  quads.isQuads = true;
  REQUIRE(arePairs(quads));
  checkSame(inGivenOrder(inCanonicalOrder(quads), quads), quads);
  TriangleMesh turned = quads;  // (a, b, c), (a, c, d) becomes (a, d, c), (a, c, b)
  for (std::size_t i = 0; i < quads.indices.size(); i += 6) {
    const Index a = quads.indices[i], b = quads.indices[i + 1], c = quads.indices[i + 2],
                d = quads.indices[i + 5];
    const Index over[] = {a, d, c, a, c, b};
    for (std::size_t k = 0; k < 6; ++k) turned.indices[i + k] = over[k];
  }
  const TriangleMesh back = inGivenOrder(inCanonicalOrder(turned), quads);
  CHECK(back.positions == quads.positions);
  CHECK(arePairs(back));
  for (std::size_t i = 0; i < quads.indices.size(); i += 6)
    CHECK(back.indices[i] == quads.indices[i]);
}

TEST_CASE("given_order: what is new follows what was given") {
  const TriangleMesh mesh = shapes::torus(12, 6);
  TriangleMesh more = inCanonicalOrder(mesh);
  const Index made = shapes::addVertex(more, {9, 9, 9});
  // First in the lists, so that it has to move.
  more.indices.insert(more.indices.begin(), {made, more.indices[0], more.indices[1]});
  const TriangleMesh back = inGivenOrder(more, mesh);
  TriangleMesh head = back;
  head.indices.resize(mesh.indices.size());
  head.positions.resize(mesh.positions.size());
  checkSame(head, mesh);
  CHECK(back.indices.size() == mesh.indices.size() + 3);
}
