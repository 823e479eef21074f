// SPDX-License-Identifier: MIT
#include "mesh/canonical_order.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "base/random.h"
#include "support/shapes.h"

using namespace remesher;

namespace {

std::vector<Index> anyOrder(std::size_t count, std::uint32_t seed) {
  std::vector<Index> order(count);
  std::iota(order.begin(), order.end(), Index{0});
  Random random(seed);
  for (std::size_t i = count; i > 1; --i)
    std::swap(order[i - 1], order[std::size_t(random.uniform() * double(i))]);
  return order;
}

// The same surface, its lists in another order, its triangles beginning at another corner.
TriangleMesh reordered(const TriangleMesh& mesh, std::uint32_t seed) {
  CanonicalOrder order;
  order.vertices = anyOrder(mesh.positions.size(), seed);
  order.numbers.resize(order.vertices.size());
  for (Index v = 0; v < order.vertices.size(); ++v) order.numbers[order.vertices[v]] = v;
  order.triangles = anyOrder(mesh.triangleCount(), seed + 1);
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t)
    order.turns.push_back(std::uint8_t((t + seed) % 3));
  return inOrder(mesh, order);
}

TriangleMesh canonical(const TriangleMesh& mesh) { return inOrder(mesh, canonicalOrder(mesh)); }

}  // namespace

TEST_CASE("canonical_order: the order of lists does not matter") {
  TriangleMesh mesh = shapes::torus(24, 12);
  // Two vertices at each place, which differ in their attribute.
  const std::size_t count = mesh.positions.size();
  for (std::size_t v = 0; v < count; ++v) mesh.positions.push_back(mesh.positions[v]);
  for (std::size_t i = 0; i < mesh.indices.size(); i += 2) mesh.indices[i] += Index(count);
  mesh.attributes.push_back({"_KIND", 1, {}});
  for (std::size_t v = 0; v < 2 * count; ++v)
    mesh.attributes[0].values.push_back(v < count ? 1.0F : 0.0F);
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t) mesh.groups.push_back(Index(t % 3));
  const TriangleMesh one = canonical(mesh);
  for (const std::uint32_t seed : {1U, 7U, 30U}) {
    const TriangleMesh other = canonical(reordered(mesh, seed));
    CHECK(other.positions == one.positions);
    CHECK(other.indices == one.indices);
    CHECK(other.groups == one.groups);
    CHECK(other.attributes[0].values == one.attributes[0].values);
  }
}

TEST_CASE("canonical_order: places that floats cannot tell apart have an order too") {
  TriangleMesh mesh;
  for (int i = 0; i < 9; ++i) mesh.positions.emplace_back(1, 1 + 1e-12 * ((i * 5) % 9), 2);
  for (Index i = 0; i < 9; i += 3) mesh.indices.insert(mesh.indices.end(), {i, i + 1, i + 2});
  const TriangleMesh one = canonical(mesh);
  CHECK(std::is_sorted(one.positions.begin(), one.positions.end(),
                       [](const Vec3& a, const Vec3& b) { return a.y() < b.y(); }));
  CHECK(canonical(reordered(mesh, 3)).indices == one.indices);
}

TEST_CASE("canonical_order: the halves of quads stay together, cut as they were") {
  TriangleMesh mesh;
  mesh.isQuads = true;
  for (Index i = 0; i < 5; ++i)
    for (Index j = 0; j < 5; ++j) mesh.positions.emplace_back(i, j, 0);
  for (Index i = 0; i < 4; ++i)
    for (Index j = 0; j < 4; ++j) {
      const Index a = 5 * i + j, b = a + 5, c = a + 6, d = a + 1;
      mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
    }
  const TriangleMesh one = canonical(mesh);
  CHECK(arePairs(one));
  TriangleMesh other = mesh;  // each quad begins at its third corner, the last quad first
  other.indices.clear();
  for (std::size_t i = mesh.indices.size(); i > 0; i -= 6) {
    const Index* const q = &mesh.indices[i - 6];
    other.indices.insert(other.indices.end(), {q[2], q[5], q[0], q[2], q[0], q[1]});
  }
  CHECK(canonical(other).indices == one.indices);
}
