// SPDX-License-Identifier: MIT
// Encodes vertex attributes as the bytes of an accessor. Floats are rounded once to the component
// type that the file had, and glTF's rules for each attribute are enforced.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "base/triangle_mesh.h"
#include "io/gltf/gltf_accessor.h"

namespace remesher::io {

// Rows of numbers, one row per vertex.
struct Table {
  int width = 0;
  std::vector<float> values;

  std::size_t rows() const { return values.size() / static_cast<std::size_t>(width); }
};

struct EncodedAccessor {
  Bytes bytes;
  std::size_t stride = 0;   // a multiple of four, as vertex attributes need
  std::vector<double> min;  // per component, of what was written
  std::vector<double> max;
};

// Integers are rounded to the nearest and clamped to their range.
EncodedAccessor encodeRows(const Table& table, const Encoding& encoding);
EncodedAccessor encodeIndices(std::span<const Index> indices, int componentType);

// The smallest type of two bytes or more that can index `vertexCount` vertices; a type's largest
// value is not an index. `wanted` is the file's type, 0 if it had none: bytes stay bytes.
int indexType(int wanted, std::size_t vertexCount);

// Makes NORMAL and TANGENT unit vectors (a zero vector gets some direction), and TANGENT's w 1 or
// -1. Rows of fewer than three numbers stay.
void makeUnitLength(Table& table);

// Makes the WEIGHTS_n of a vertex, all sets together, sum to one: integers are rounded so that
// their sum is exact. If all weights are zero, which glTF forbids, the first becomes one.
void normalizeWeights(std::span<Table> sets, int componentType);

// Whether the numbers are the same after writing and reading them in this encoding.
bool holdsExactly(const Table& table, const Encoding& encoding);

}  // namespace remesher::io
