// SPDX-License-Identifier: MIT
#include "remesh/quads/graded_sizes.h"

#include <doctest/doctest.h>

#include <cmath>

#include "support/working_meshes.h"

using namespace remesher;

namespace {

// The size of each face beside the square root of its distance from the axis, at most and least.
std::pair<double, double> sizesByRoots(const TriangleMesh& shape) {
  const OriginalSurface surface = shapes::surfaceOf(shape);
  const WorkingMesh mesh(surface);
  const FaceFrames frames(mesh);
  const FaceData<double> sizes = crossSizes(mesh, frames, makeCrossField(mesh, frames, 0.1));
  double least = kInfinity, most = 0;
  for (Index f = 0; f < sizes.size(); ++f) {
    const auto [a, b, c] = mesh.corners(Face(f));
    const double share = sizes[Face(f)] / std::sqrt(((a + b + c) / 3).norm());
    least = std::min(least, share);
    most = std::max(most, share);
  }
  return {least, most};
}

}  // namespace

// Along circles and rays, squares are as large as they are far from the middle: halfway to that is
// the root. (Even sizes differ by 1.73 from it.)
TEST_CASE("graded_sizes: between circles quads grow as the root of the radius") {
  TriangleMesh ring;
  shapes::addSheet(ring, 60, 16,
                   [&](int x, int y) { return Vec3((1 + y / 8.0) * shapes::onCircle(x, 60)); });
  const auto [least, most] = sizesByRoots(ring);
  CHECK(most / least < 1.1);
}

TEST_CASE("graded_sizes: on a flat sheet all quads are of one size") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::grid(9, 6));
  const WorkingMesh mesh(surface);
  const FaceFrames frames(mesh);
  const FaceData<double> sizes = crossSizes(mesh, frames, makeCrossField(mesh, frames, 1));
  for (Index f = 0; f < sizes.size(); ++f) CHECK(sizes[Face(f)] == doctest::Approx(1));
}
