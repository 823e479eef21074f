// SPDX-License-Identifier: MIT
#include "mesh/used_vertices.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "repair/repair.h"
#include "support/shapes.h"

using namespace remesher;

namespace {

// A ball whose vertices have their coordinates as an attribute, with `unused` more vertices before,
// among and after its own.
TriangleMesh ballAmong(std::size_t unused) {
  const TriangleMesh ball = shapes::icosphere(2);
  TriangleMesh mesh;
  std::vector<Index> numbers;
  const auto addUnused = [&] {
    for (std::size_t i = 0; i < unused; ++i) mesh.positions.emplace_back(100, double(i), 0);
  };
  for (std::size_t v = 0; v < ball.positions.size(); ++v) {
    if (v % 50 == 0) addUnused();
    numbers.push_back(Index(mesh.positions.size()));
    mesh.positions.push_back(ball.positions[v]);
  }
  addUnused();
  for (const Index v : ball.indices) mesh.indices.push_back(numbers[v]);
  mesh.attributes.push_back({"_OWN", 3, {}});
  for (const Vec3& p : mesh.positions)
    for (const double x : p) mesh.attributes[0].values.push_back(float(x));
  return mesh;
}

}  // namespace

TEST_CASE("used vertices: each stays, with its values, in its order, and each triangle as it was") {
  const TriangleMesh ball = shapes::icosphere(2);
  for (const std::size_t unused : {0, 1, 7}) {
    TriangleMesh mesh = ballAmong(unused);
    keepUsedVertices(mesh);
    CHECK(mesh.positions == ball.positions);
    CHECK(mesh.indices == ball.indices);
    CHECK(mesh.attributes[0].values == ballAmong(0).attributes[0].values);
  }
}

TEST_CASE("used vertices: repair leaves no others, except where it changes nothing") {
  PartOptions options;
  for (const Repair mode : {Repair::Holes, Repair::Auto})
    for (const std::size_t removed : {1, 6}) {  // triangles
      TriangleMesh mesh = ballAmong(3);
      mesh.indices.resize(mesh.indices.size() - 3 * removed);
      options.repair = mode;
      const TriangleMesh result = repairSurface(mesh, options).mesh;
      std::vector<char> isUsed(result.positions.size(), 0);
      for (const Index v : result.indices) isUsed[v] = 1;
      CHECK(std::count(isUsed.begin(), isUsed.end(), 0) == 0);
    }
}
