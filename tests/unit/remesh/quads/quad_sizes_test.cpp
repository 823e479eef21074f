// SPDX-License-Identifier: MIT
#include "remesh/quads/quad_sizes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/working_meshes.h"

using namespace remesher;

namespace {

struct Range {
  double least = kInfinity, most = 0;
};

// The sizes of faces in the ring from radius 1 to `outer`, each beside its distance from the middle
// or beside 1.
Range sizesInRing(double outer, bool isByRadius) {
  TriangleMesh ring;
  const int columns = 96, rows = int(columns * std::log(outer) / std::numbers::pi / 2);
  shapes::addSheet(ring, columns, rows, [&](int x, int y) {
    return Vec3(std::pow(outer, double(y) / rows) * shapes::onCircle(x, columns));
  });
  const OriginalSurface surface = shapes::surfaceOf(ring);
  const WorkingMesh mesh(surface);
  const FaceFrames frames(mesh);
  const FaceData<double> sizes = crossSizes(mesh, frames, makeCrossField(mesh, frames, 0.1));
  Range range;
  for (Index f = 0; f < sizes.size(); ++f) {
    const auto [a, b, c] = mesh.corners(Face(f));
    const double share = sizes[Face(f)] / (isByRadius ? ((a + b + c) / 3).norm() : 1);
    range = {std::min(range.least, share), std::max(range.most, share)};
  }
  return range;
}

}  // namespace

// Along circles and rays, squares are as large as they are far from the middle.
TEST_CASE("quad_sizes: between circles quads grow as the radius") {
  const Range range = sizesInRing(1.4, true);
  CHECK(range.most / range.least < 1.03);
}

TEST_CASE("quad_sizes: however wide a ring, no size is far from the mean") {
  const Range range = sizesInRing(4, false);
  CHECK(range.most / range.least < 1.6);
  CHECK(range.most / range.least > 1.5);
}

TEST_CASE("quad_sizes: on a flat sheet all quads are of one size") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::grid(9, 6));
  const WorkingMesh mesh(surface);
  const FaceFrames frames(mesh);
  const FaceData<double> sizes = crossSizes(mesh, frames, makeCrossField(mesh, frames, 1));
  for (Index f = 0; f < sizes.size(); ++f) CHECK(sizes[Face(f)] == doctest::Approx(1));
}
