// SPDX-License-Identifier: MIT
#include "io/gltf/gltf_encoder.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace remesher;
using namespace remesher::io;

TEST_CASE("gltf_encoder: integers are rounded once and clamped, rows begin at multiples of four") {
  const Table table{3, {0, 0.5F, 1, -0.1F, 1.5F, 0.2F}};
  const EncodedAccessor bytes = encodeRows(table, {TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, true, 3});
  CHECK(bytes.stride == 4);
  CHECK(bytes.bytes == Bytes{0, 128, 255, 0, 0, 255, 51, 0});
  CHECK(bytes.min == std::vector<double>{0, 128, 51});
  const Table negative{1, {-1, -2}};
  CHECK(encodeRows(negative, {TINYGLTF_COMPONENT_TYPE_BYTE, true, 1}).max ==
        std::vector<double>{-127});
  CHECK(encodeRows(negative, {TINYGLTF_COMPONENT_TYPE_SHORT, false, 1}).min ==
        std::vector<double>{-2});
}

TEST_CASE("gltf_encoder: index types are the file's own where they suffice") {
  CHECK(indexType(TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, 255) ==
        TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE);
  CHECK(indexType(TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, 256) ==
        TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT);
  CHECK(indexType(0, 65535) == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT);
  CHECK(indexType(0, 65536) == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT);
  CHECK(indexType(TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, 3) ==
        TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT);
}

TEST_CASE("gltf_encoder: directions get unit length, good ones stay bit for bit") {
  Table normals{3, {0, 0, 0, 3, 4, 0, 0.6F, 0.8F, 0}};
  makeUnitLength(normals);
  CHECK(normals.values[2] == 1.0F);
  CHECK(normals.values[3] == doctest::Approx(0.6));
  CHECK(normals.values[6] == 0.6F);
  Table tangents{4, {2, 0, 0, -0.3F}};
  makeUnitLength(tangents);
  CHECK(tangents.values == std::vector<float>{1, 0, 0, -1});
  Table scalars{1, {0, 2}};
  makeUnitLength(scalars);
  CHECK(scalars.values == std::vector<float>{0, 2});
}

TEST_CASE("gltf_encoder: weights that are all zero become a whole one") {
  for (const int type : {TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE}) {
    std::vector<Table> sets = {{4, {0, 0, 0, 0, 0.25F, 0.75F, 0, 0}}};
    normalizeWeights(sets, type);
    CHECK(sets[0].values[0] == 1.0F);
    CHECK(sets[0].values[4] == doctest::Approx(0.25).epsilon(0.01));
  }
}

TEST_CASE("gltf_encoder: weights in single precision sum to one, good ones stay bit for bit") {
  std::vector<Table> sets = {{4, {1e-39F, 3e-39F, 0, 0, 0.25F, 0.75F, 0, 0}}};
  normalizeWeights(sets, TINYGLTF_COMPONENT_TYPE_FLOAT);
  CHECK(sets[0].values[0] == doctest::Approx(0.25));
  CHECK(sets[0].values[1] == doctest::Approx(0.75));
  CHECK(std::vector(sets[0].values.begin() + 4, sets[0].values.end()) ==
        std::vector{0.25F, 0.75F, 0.0F, 0.0F});
}

TEST_CASE("gltf_encoder: weights of all sets together sum to exactly one") {
  std::vector<Table> sets(2, Table{4, {1 / 8.0F, 1 / 8.0F, 1 / 8.0F, 1 / 8.0F}});
  normalizeWeights(sets, TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE);
  double sum = 0;
  for (const Table& set : sets)
    for (const float weight : set.values) sum += std::round(255.0 * weight);
  CHECK(sum == 255);
}

TEST_CASE("gltf_encoder: what integers hold exactly is known") {
  const Encoding fractions{TINYGLTF_COMPONENT_TYPE_SHORT, true, 3};
  const Encoding steps{TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, false, 3};
  Table table{3, {}};
  for (int i = -32767; i <= 32767; ++i) table.values.push_back(static_cast<float>(i) / 32767.0F);
  CHECK(holdsExactly(table, fractions));
  CHECK(holdsExactly(table, {TINYGLTF_COMPONENT_TYPE_FLOAT, false, 3}));
  CHECK(!holdsExactly(table, steps));
  CHECK(!holdsExactly({3, {0.5F, 0, 0}}, fractions));
  CHECK(!holdsExactly({3, {1.5F, 0, 0}}, fractions));
  CHECK(holdsExactly({3, {0, 7, 65535}}, steps));
  CHECK(!holdsExactly({3, {0, 7, 65536}}, steps));
  CHECK(!holdsExactly({3, {0, -1, 7}}, steps));
}
