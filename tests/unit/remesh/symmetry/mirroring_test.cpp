// SPDX-License-Identifier: MIT
#include "remesh/symmetry/mirroring.h"

#include <doctest/doctest.h>

#include <set>
#include <utility>

#include "support/quad_sheets.h"

using namespace remesher;

namespace {

TriangleMesh sheetOfQuads() {
  const QuadMesh quads = shapes::quadSheet(2, 3, shapes::Wraps::No, shapes::flat);
  TriangleMesh mesh;
  mesh.isQuads = true;
  for (const Placement& place : quads.vertices) mesh.positions.push_back(place.position);
  for (const auto& [a, b, c, d] : quads.quads)
    mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
  return mesh;
}

}  // namespace

TEST_CASE("mirroring: images join along the planes and turn like the half") {
  const TriangleMesh half = sheetOfQuads();
  const MirroredQuads made =
      mirroredQuads(half, {{{Vec3::UnitX(), 0}, {Vec3::UnitY(), 0}}, 1e-9, 0});
  CHECK(made.quads.size() == 4 * 6);
  const std::vector<Index> places = placeNumbers(made);
  CHECK(std::set<Index>(places.begin(), places.end()).size() == 5 * 7);
  for (const MirroredQuad& quad : made.quads) {
    const auto at = [&](std::size_t k) { return made.vertices[quad.vertices[k]].position; };
    CHECK((at(2) - at(0)).cross(at(3) - at(1)).z() == doctest::Approx(2));
    for (std::size_t k = 0; k < 4; ++k)
      CHECK(half.indices[quad.corners[k]] == made.vertices[quad.vertices[k]].source);
  }
}

TEST_CASE("mirroring: no diagonal in a plane has an image there") {
  TriangleMesh half;
  half.isQuads = true;
  half.positions = {{0, 0, 0}, {1, 1, 0}, {0, 2, 0}, {1, 1, 1}};
  half.indices = {0, 1, 2, 0, 2, 3};
  const MirroredQuads made = mirroredQuads(half, {{{Vec3::UnitX(), 0}}, 1e-9, 0});
  const std::vector<Index> places = placeNumbers(made);
  REQUIRE(made.quads.size() == 2);
  const auto diagonal = [&](std::size_t q) {
    return std::pair(places[made.quads[q].vertices[0]], places[made.quads[q].vertices[2]]);
  };
  CHECK(diagonal(0) == std::pair(Index{0}, Index{2}));
  CHECK(made.vertices[made.quads[1].vertices[0]].position.x() == -1);
  CHECK(made.vertices[made.quads[1].vertices[2]].position.x() == -1);
}
