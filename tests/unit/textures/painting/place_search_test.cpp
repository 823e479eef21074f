// SPDX-License-Identifier: MIT
#include "textures/painting/place_search.h"

#include <doctest/doctest.h>

#include "textures/painting/squares.h"

using namespace remesher;

using namespace remesher::test;

TEST_CASE("place search: of a thin wall each side finds the side that faces alike") {
  TriangleMesh wall;
  addSquare(wall, 0, Facing::Down);
  addSquare(wall, 1e-3, Facing::Up);
  const auto source = sourceOf(wall);
  const PlaceSearch search(*source);
  for (const double z : {-2e-4, 2e-4, 7e-4, 3e-3}) {
    CHECK(search.at({0.6, 0.4, z}, Vec3::UnitZ()).triangle.index / 2 == 1);
    CHECK(search.at({0.6, 0.4, z}, -Vec3::UnitZ()).triangle.index / 2 == 0);
  }
  // Nothing faces along x: the nearest place will do.
  CHECK(search.at({0.6, 0.4, 2e-3}, Vec3::UnitX()).triangle.index / 2 == 1);
}

TEST_CASE("place search: corners at a sharp edge are on the side of their triangle") {
  TriangleMesh bend;
  bend.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, -1}, {1, 1, -1}};
  bend.indices = {0, 1, 2, 0, 2, 3, 1, 4, 5, 1, 5, 2};
  const auto source = sourceOf(bend);
  const std::vector<InputPlace> places = placesOn(bend, *source);
  REQUIRE(places.size() == bend.indices.size());
  for (std::size_t h = 0; h < places.size(); ++h) {
    CHECK(places[h].triangle.index / 2 == h / 6);
    CHECK((source->position(places[h]) - bend.positions[bend.indices[h]]).norm() < 0.05);
  }
}
