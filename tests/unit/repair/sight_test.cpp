// SPDX-License-Identifier: MIT
#include "repair/sight.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "support/shapes.h"
#include "support/soups.h"

using namespace remesher;

namespace {

std::vector<char> seen(const TriangleMesh& mesh) {
  const std::vector<char> isClear(mesh.triangleCount(), 0);
  return seenFromOutside({mesh.positions, mesh.indices, isClear});
}

// How many of these triangles are seen.
std::size_t countSeen(const std::vector<char>& isSeen, std::size_t from, std::size_t to) {
  return std::size_t(
      std::count(isSeen.begin() + std::ptrdiff_t(from), isSeen.begin() + std::ptrdiff_t(to), 1));
}

}  // namespace

TEST_CASE("sight: all of a lone surface is seen, nothing of one inside it") {
  for (const TriangleMesh& mesh :
       {shapes::icosphere(5), shapes::cube(2), shapes::torus(20, 10), shapes::grid(4, 3)}) {
    const std::vector<char> isSeen = seen(mesh);
    CHECK(countSeen(isSeen, 0, isSeen.size()) == mesh.triangleCount());
  }
  TriangleMesh inner = shapes::torus(20, 10);
  for (Vec3& p : inner.positions) p *= 0.25;
  const TriangleMesh ball = shapes::icosphere(4);
  const std::vector<char> both = seen(soups::joined({ball, inner}));
  CHECK(countSeen(both, 0, ball.triangleCount()) == ball.triangleCount());
  CHECK(countSeen(both, ball.triangleCount(), both.size()) == 0);
}

TEST_CASE("sight: through an opening and through what is clear the inside is seen") {
  TriangleMesh open = shapes::icosphere(6), inner = shapes::icosphere(3);
  for (Vec3& p : inner.positions) p *= 0.5;
  const TriangleMesh closed = open;
  open.indices.erase(open.indices.begin(), open.indices.begin() + 60);
  const std::vector<char> through = seen(soups::joined({open, inner}));
  CHECK(countSeen(through, open.triangleCount(), through.size()) > 0);
  const TriangleMesh both = soups::joined({closed, inner});
  std::vector<char> isClear(both.triangleCount(), 0);
  std::fill_n(isClear.begin(), closed.triangleCount(), char{1});
  const std::vector<char> behindGlass = seenFromOutside({both.positions, both.indices, isClear});
  CHECK(countSeen(behindGlass, 0, behindGlass.size()) == both.triangleCount());
}

TEST_CASE("sight: of bodies that intersect a triangle is hidden only if it lies in the other") {
  const TriangleMesh ball = shapes::icosphere(6), other = soups::moved(ball, {0.9, 0.1, 0.2});
  const TriangleMesh both = soups::joined({ball, other});
  const std::vector<char> isSeen = seen(both);
  for (std::size_t t = 0; t < isSeen.size(); ++t) {
    const Vec3 centre = t < ball.triangleCount() ? Vec3(0.9, 0.1, 0.2) : Vec3(0, 0, 0);
    double farthest = 0;
    for (std::size_t k = 0; k < 3; ++k)
      farthest = std::max(farthest, (both.positions[both.indices[3 * t + k]] - centre).norm());
    if (farthest < 0.9) CHECK(isSeen[t] == 0);
    if (farthest > 1) CHECK(isSeen[t] == 1);
  }
}
