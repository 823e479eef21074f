// SPDX-License-Identifier: MIT
#include "original/surface/original_tree.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "support/working_meshes.h"

using namespace remesher;

namespace {

double distanceToAll(const OriginalSurface& surface, const Vec3& p) {
  double least = std::numeric_limits<double>::infinity();
  for (Index i = 0; i < surface.mesh().faceCapacity(); ++i) {
    const auto [a, b, c] = surface.mesh().vertices(Face(i));
    const auto& at = surface.positions();
    least = std::min(least, distance(p, closestPoint(p, at[a], at[b], at[c])));
  }
  return least;
}

// Triangles between one vertex and itself.
TriangleMesh withLines(TriangleMesh mesh) {
  for (Index v = 0; v < 9; v += 3) mesh.indices.insert(mesh.indices.begin(), {v, v, v + 1});
  return mesh;
}

TriangleMesh withCopies(TriangleMesh mesh) {
  for (std::size_t i = 0; i < 9; ++i) mesh.indices.push_back(mesh.indices[i]);
  return mesh;
}

}  // namespace

TEST_CASE("original_tree: no triangle is nearer, from any start, whatever the tree is of") {
  for (const TriangleMesh& input : {shapes::torus(12, 6), withLines(shapes::icosphere(3))}) {
    const OriginalSurface surface = shapes::surfaceOf(input);
    OriginalTree own(surface), ofInput(surface, &input);
    soups::Random random(5);
    for (int round = 0; round < 200; ++round) {
      const Vec3 p = 4 * random.point() - 2 * Vec3::Ones();
      const Face start(Index(random.number() * double(surface.mesh().faceCapacity())));
      const double expected = distanceToAll(surface, p);
      for (OriginalTree* tree : {&own, &ofInput})
        CHECK(tree->nearest(p, start).distance == doctest::Approx(expected).epsilon(1e-12));
    }
  }
}

TEST_CASE("original_tree: whoever measures gets each triangle of the input once, or no tree") {
  const TriangleMesh sphere = shapes::icosphere(3), lines = withLines(sphere);
  for (const TriangleMesh* input : {&sphere, &lines}) {
    const OriginalSurface surface = shapes::surfaceOf(*input);
    OriginalTree tree(surface, input);
    CHECK(!tree.ofInput());
    tree.nearest(Vec3::Zero(), Face(0));
    const std::optional<ListedTree> given = tree.ofInput();
    REQUIRE(given);
    CHECK(given->indices.size() == sphere.indices.size());
    CHECK(given->tree.nearest(2 * input->positions[5]).point == input->positions[5]);
    CHECK(!tree.ofInput());
  }
  const TriangleMesh copies = withCopies(sphere);
  const OriginalSurface surface = shapes::surfaceOf(copies);
  OriginalTree tree(surface, &copies);
  tree.nearest(Vec3::Zero(), Face(0));
  CHECK(!tree.ofInput());
}
