// SPDX-License-Identifier: MIT
#include "remesh/quads/shape/mending.h"

#include <doctest/doctest.h>

#include "remesh/quads/mesh/quad_check.h"
#include "remesh/quads/mesh/quad_parts.h"
#include "support/quad_sheets.h"

using namespace remesher;

TEST_CASE("mending: a quad that was made two by a vertex across it is one again") {
  const QuadMesh sound = shapes::quadSheet(4, 3, shapes::Wraps::No, shapes::flat);
  for (const bool isTurned : {false, true}) {
    QuadMesh mesh = sound;
    const auto [a, b, c, d] = mesh.quads[5];
    const Index v = Index(mesh.vertices.size());
    mesh.vertices.push_back(shapes::placed((mesh.position(a) + mesh.position(c)) / 2));
    mesh.quads[5] = isTurned ? Four<Index>{b, v, d, a} : Four<Index>{a, b, c, v};
    mesh.quads.push_back(isTurned ? Four<Index>{v, b, c, d} : Four<Index>{v, c, d, a});
    mesh.curves.push_back({kNone, kNone, kNone, kNone});
    REQUIRE(check(mesh) == "two quads share two sides");
    removeDoublets(mesh);
    dropUnusedVertices(mesh);
    CHECK(check(mesh) == "");
    CHECK(kindOf(mesh) == kindOf(sound));
    CHECK(mesh.quads.size() == sound.quads.size());
    CHECK(mesh.vertices.size() == sound.vertices.size());
  }
}

TEST_CASE("mending: what the curves of joined quads followed is kept") {
  QuadMesh mesh = shapes::quadSheet(1, 1, shapes::Wraps::No, shapes::flat);
  const auto [a, b, c, d] = mesh.quads[0];
  mesh.vertices.push_back(shapes::placed({0.5, 0.5, 0}));
  mesh.quads = {{a, b, c, 4}, {4, c, d, a}};
  mesh.curves = {{10, 11, kNone, kNone}, {kNone, 12, 13, kNone}};
  removeDoublets(mesh);
  REQUIRE(mesh.quads.size() == 1);
  for (std::size_t i = 0; i < 4; ++i) {
    const Index from = mesh.quads[0][i];
    const Index wanted = from == a ? 10 : from == b ? 11 : from == c ? 12 : 13;
    CHECK(mesh.curves[0][i] == wanted);
  }
}
