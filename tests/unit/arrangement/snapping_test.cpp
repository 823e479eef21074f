// SPDX-License-Identifier: MIT
#include "arrangement/snapping.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

#include "base/place.h"
#include "geometry/triangle.h"
#include "support/soups.h"

using namespace remesher;

namespace {

constexpr double kNear = 1e-6;

KeptFacets facetsOf(const TriangleMesh& mesh) {
  KeptFacets facets{mesh.indices, {}};
  for (Index t = 0; t < mesh.triangleCount(); ++t) facets.from.push_back({t, 1});
  return facets;
}

KeptFacets snapped(TriangleMesh& mesh) {
  KeptFacets facets = facetsOf(mesh);
  std::vector<Index> all(mesh.triangleCount());
  std::iota(all.begin(), all.end(), Index{0});
  snapTogether(mesh.positions, facets, all, {kNear, [](const Vec3& p) { return p; }});
  return facets;
}

// Whether as many facets run along each edge one way as the other.
bool isClosed(const KeptFacets& facets) {
  std::map<std::array<Index, 2>, int> sums;
  for (std::size_t i = 0; i < facets.corners.size(); ++i) {
    const Index a = facets.corners[i], b = facets.corners[i % 3 == 2 ? i - 2 : i + 1];
    sums[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
  }
  return std::all_of(sums.begin(), sums.end(), [](const auto& sum) { return sum.second == 0; });
}

// The area of facets of which another one has the same corners.
double areaAlike(const TriangleMesh& mesh, const KeptFacets& facets) {
  std::map<std::array<Index, 3>, std::size_t> alike;
  for (std::size_t f = 0; f < facets.from.size(); ++f) {
    std::array<Index, 3> c = {facets.corners[3 * f], facets.corners[3 * f + 1],
                              facets.corners[3 * f + 2]};
    std::sort(c.begin(), c.end());
    ++alike[c];
  }
  double sum = 0;
  for (const auto& [c, times] : alike)
    if (times > 1)
      sum += double(times) * area(mesh.positions[c[0]], mesh.positions[c[1]], mesh.positions[c[2]]);
  return sum;
}

// With one vertex at each position.
TriangleMesh welded(const TriangleMesh& mesh) {
  const std::vector<Index> first = weld(mesh.positions);
  TriangleMesh result = mesh;
  for (Index& v : result.indices) v = first[v];
  return result;
}

TriangleMesh onEachOther(double gap) {
  TriangleMesh upper = soups::cube(0, 1);
  for (Vec3& p : upper.positions) p = Vec3(0.3, 0.2, 1 + gap) + 0.5 * p;
  return welded(soups::joined({soups::cube(0, 1), upper}));
}

}  // namespace

TEST_CASE("snapping: faces that nearly lie on each other get the same triangles") {
  TriangleMesh mesh = onEachOther(1e-7);
  const std::vector<Vec3> before = mesh.positions;
  const KeptFacets facets = snapped(mesh);
  CHECK(isClosed(facets));
  CHECK(areaAlike(mesh, facets) > 0.8 * 2 * 0.25);  // of the upper face, on both sides
  CHECK(std::equal(before.begin(), before.end(), mesh.positions.begin()));
}

TEST_CASE("snapping: what is farther away than the tolerance stays") {
  TriangleMesh mesh = onEachOther(1e-5);
  const KeptFacets facets = snapped(mesh);
  CHECK(facets.corners == mesh.indices);
}

TEST_CASE("snapping: where the tolerance is as wide as facets, it ends within the most work") {
  TriangleMesh mesh;
  constexpr Index kSide = 6;
  for (const double height : {0.0, 0.9})  // cells 1.1 wide, shifted by half of that above
    for (Index i = 0; i < kSide * kSide; ++i)
      mesh.positions.emplace_back(1.1 * (i % kSide) + height / 2, 1.1 * (i / kSide), height);
  for (const Index first : {Index{0}, kSide * kSide})
    for (Index i = 0; i + kSide < kSide * kSide; ++i) {
      if (i % kSide + 1 == kSide) continue;
      const Index a = first + i, b = a + 1, c = a + kSide, d = c + 1;
      mesh.indices.insert(mesh.indices.end(), {a, b, d, a, d, c});
    }
  KeptFacets facets = facetsOf(mesh);
  std::vector<Index> all(mesh.triangleCount());
  std::iota(all.begin(), all.end(), Index{0});
  const auto same = [](const Vec3& p) { return p; };
  CHECK_FALSE(snapTogether(mesh.positions, facets, all, {1, same, 5000}));
  CHECK(facets.from.size() < mesh.triangleCount() + 5000 / 16);
}

TEST_CASE("snapping: a corner beside an edge divides it, for all facets there") {
  // A tetrahedron whose corner is almost on an edge of the first: both stay closed.
  TriangleMesh mesh = welded(soups::cube(0, 1));
  const Vec3 tip(0.5, 1e-7, 1);
  const Index first = Index(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(),
                        {tip, tip + Vec3(1, 0.2, 1), tip + Vec3(-1, 0.2, 1), tip + Vec3(0, 1, 1)});
  for (const Index corner : {0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2})
    mesh.indices.push_back(first + corner);
  const std::size_t before = mesh.triangleCount();
  const KeptFacets facets = snapped(mesh);
  CHECK(isClosed(facets));
  CHECK(facets.from.size() == before + 2);
}
