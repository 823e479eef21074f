// SPDX-License-Identifier: MIT
#include "io/gltf/gltf_shared_levels.h"

#include <doctest/doctest.h>

using namespace remesher;
using namespace remesher::io;

namespace {

// A fan of triangles around vertex 0, whose texture coordinates are the numbers of its vertices.
TriangleMesh fan(Index triangles, Index step) {
  TriangleMesh mesh;
  Attribute texcoords{"TEXCOORD_0", 2, {}};
  for (Index v = 0; v <= triangles + 1; ++v) {
    const Index place = v == 0 ? 0 : 1 + (v - 1) * step;
    mesh.positions.emplace_back(place, place * place, 0);
    texcoords.values.insert(texcoords.values.end(), {float(place), 0});
    if (v > 1) mesh.indices.insert(mesh.indices.end(), {0, v - 1, v});
  }
  mesh.attributes.push_back(texcoords);
  return mesh;
}

}  // namespace

TEST_CASE("gltf_shared_levels: a level is triangles on the vertices of the finest") {
  const TriangleMesh finest = fan(8, 1), level = fan(4, 2);
  const std::optional<TriangleMesh> shared = sharedLevels(finest, {level}, 1);
  REQUIRE(shared);
  CHECK(shared->positions == finest.positions);
  CHECK(shared->attributes[0].values == finest.attributes[0].values);
  REQUIRE(shared->triangleCount() == 12);
  for (std::size_t i = 0; i < level.indices.size(); ++i)
    CHECK(shared->positions[shared->indices[24 + i]] == level.positions[level.indices[i]]);
  for (std::size_t t = 0; t < 12; ++t) CHECK(shared->groups[t] == (t < 8 ? 0U : 1U));
}

TEST_CASE("gltf_shared_levels: up to half of a level may be its own and comes last, no more") {
  const TriangleMesh finest = fan(8, 1);
  TriangleMesh level = fan(4, 2);
  for (const std::size_t v : {1U, 2U, 3U}) level.attributes[0].values[2 * v] = 100;
  const std::optional<TriangleMesh> shared = sharedLevels(finest, {level}, 1);
  REQUIRE(shared);
  CHECK(shared->positions.size() == finest.positions.size() + 3);
  CHECK(shared->positions.back() == level.positions[3]);
  CHECK(shared->attributes[0].values.end()[-2] == 100);
  level.attributes[0].values[8] = 100;  // of vertex 4
  CHECK_FALSE(sharedLevels(finest, {level}, 1));
  CHECK_FALSE(sharedLevels(finest, {}, 1));
  level.attributes.clear();
  CHECK_FALSE(sharedLevels(finest, {level}, 1));
}
