// SPDX-License-Identifier: MIT
#include "mesh/handles.h"

#include <doctest/doctest.h>

#include <type_traits>

using namespace remesher;

TEST_CASE("handles: one kind cannot be passed for another, nor a number for any") {
  CHECK_FALSE(std::is_convertible_v<Face, Vertex>);
  CHECK_FALSE(std::is_constructible_v<Vertex, Face>);
  CHECK_FALSE(std::is_convertible_v<Index, Vertex>);
  CHECK(sizeof(Halfedge) == sizeof(Index));
}

TEST_CASE("handles: a fresh handle names nothing, index 0 is a handle like any other") {
  CHECK_FALSE(Vertex());
  CHECK(Vertex(0));
  CHECK(Vertex() == Vertex(kNone));
  CHECK(Vertex(1) < Vertex(2));
  CHECK(Vertex(2) < Vertex());
}

TEST_CASE("handles: data is indexed by its own kind of handle and keeps values when it grows") {
  FaceData<int> data(2, 7);
  data[Face(1)] = 9;
  data.resize(4, 5);
  CHECK(data.values() == std::vector<int>{7, 9, 5, 5});
  data.assign(1, 3);
  CHECK(data.size() == 1);
  CHECK(data[Face(0)] == 3);
}
