// SPDX-License-Identifier: MIT
#include "remesh/schemes/edge_limits.h"

#include <doctest/doctest.h>

#include "original/surface/size_field.h"

using namespace remesher;

TEST_CASE("edge limits: sizes leave room on both sides, or lie between the limits") {
  PartOptions options;
  CHECK(sizeBounds(options).shortest == 0);
  CHECK(sizeBounds(options).longest == kInfinity);
  options.maxEdge = 2;
  options.minEdge = 0.5;
  CHECK(sizeBounds(options).shortest > 0.5);
  CHECK(sizeBounds(options).longest < 2);
  options.minEdge = 1.9;
  CHECK(sizeBounds(options).shortest == sizeBounds(options).longest);
  CHECK(sizeBounds(options).shortest > 1.9);
  CHECK(sizeBounds(options).longest < 2);
}

TEST_CASE("edge limits: a longest edge leads the number, a shortest one only limits it") {
  PartOptions options;
  options.maxEdge = 2;
  const double coarse = numberByEdges(options, 100, 10);
  options.maxEdge = 1;
  CHECK(numberByEdges(options, 100, 10) == doctest::Approx(4 * coarse));
  CHECK(coarse > verticesForEdgeLength(100, 2));
  options.maxEdge.reset();
  options.minEdge = 1;
  CHECK(numberByEdges(options, 100, 10) == 10);
  CHECK(numberByEdges(options, 100, 1e6) < verticesForEdgeLength(100, 1));
}
