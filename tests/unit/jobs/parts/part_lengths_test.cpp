// SPDX-License-Identifier: MIT
#include "jobs/parts/part_lengths.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "jobs/parts/part_joining.h"
#include "mesh/joining.h"
#include "support/shapes.h"

namespace remesher {

namespace {

// A tetrahedron shown so many times as large, at some way from the origin.
io::Part shownTetrahedron(double size) {
  Transform place = Transform(Eigen::Translation3d(Vec3(3, 1, 2) * size));
  place.linear() *= size;
  return io::Part{"", shapes::tetrahedron(), {place}};
}

}  // namespace

TEST_CASE("part lengths: a length is its percent of the diagonal in the world") {
  const io::Part part = shownTetrahedron(1000);
  const double diagonal = worldDiagonal({part});
  CHECK(diagonal == doctest::Approx(1000 * diagonalOf(part.mesh)));
  PartOptions options;
  options.lengths.maxError = 0.02 * diagonal;
  options.lengths.dropBelow = 0.5 * diagonal;
  options = withPercents(options, {part});
  CHECK(*options.maxError == doctest::Approx(2));
  CHECK(*options.dropBelow == doctest::Approx(50));
  CHECK_FALSE(options.weld.has_value());
}

TEST_CASE("part lengths: each part has its own percent, for the same length in the world") {
  const io::Part large = shownTetrahedron(100), small = shownTetrahedron(1);
  PartOptions options;
  options.lengths.gap = 0.1;
  options.lengths.dropBelow = 0.1;
  options = withPercents(options, {large, small});
  const auto of = [&](const io::Part& part) {
    return withPercentsOf(part.mesh, growthOf(part.instances.front()), options);
  };
  CHECK(*of(small).gap == doctest::Approx(100 * *of(large).gap));
  CHECK(*of(small).dropBelow == *options.dropBelow);
}

TEST_CASE("part lengths: options in percent stay as they are, and so does nothing at all") {
  PartOptions options;
  options.maxError = 3;
  CHECK(*withPercents(options, {shownTetrahedron(7)}).maxError == 3);
  CHECK(*withPercentsOf(shapes::tetrahedron(), 5, options).maxError == 3);
  options.lengths.weld = 1;
  CHECK(worldDiagonal({}) == 0);
  CHECK_FALSE(withPercents(options, std::vector<io::Part>{}).weld.has_value());
}

TEST_CASE("part lengths: a mean length of edges limits each edge where angles are limited") {
  PartOptions options;
  options.edgeLength = 5;
  const auto limited = [&] {
    PartOptions own = options;
    limitEdges(own);
    return own;
  };
  CHECK_FALSE(limited().maxEdge.has_value());
  options.minAngle = 20;
  CHECK(*limited().minEdge == doctest::Approx(2));
  CHECK(*limited().maxEdge == doctest::Approx(10));
  options.maxEdge = 1;
  CHECK(*limited().minEdge == doctest::Approx(0.4));
  CHECK(*limited().maxEdge == 1);
  options.maxError = 0.1;
  CHECK_FALSE(limited().minEdge.has_value());
}

TEST_CASE(
    "part lengths: places nearer than a length in the world are joined, however it is shown") {
  for (const double size : {0.001, 1.0, 1000.0}) {
    io::Part part = shownTetrahedron(size);
    const Vec3 first = part.mesh.positions[0];
    part.mesh.positions.push_back(first + Vec3(1e-3, 0, 0));  // a millionth at the smallest place
    std::replace(part.mesh.indices.begin(), part.mesh.indices.begin() + 3, Index(0), Index(4));
    PartOptions options;
    options.lengths.weld = 0.002 * size;
    CHECK(joinedPlaces({part}, options)[0].mesh.positions[4] == first);
    options.lengths.weld = 0.0005 * size;
    CHECK(joinedPlaces({part}, options)[0].mesh.positions[4] != first);
  }
}

}  // namespace remesher
