// SPDX-License-Identifier: MIT
// Values of vertex attributes as the bytes of an accessor: floats become whatever component type
// the file had, rounded once, and what glTF promises of an attribute is made to hold.
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

// The type as small as the file's own and large enough for `vertexCount` vertices: the largest
// value of a type is no index. `wanted` is the file's, 0 if it had none.
int indexType(int wanted, std::size_t vertexCount);

// NORMAL and TANGENT of unit length (a zero one points somewhere), TANGENT's w 1 or -1. Rows of
// fewer than three numbers are neither, and stay.
void makeUnitLength(Table& table);

// WEIGHTS_n of a vertex, all sets together: integers are rounded so that their sum is still exactly
// one; where all are zero, as they may not be, the first becomes one.
void normalizeWeights(std::span<Table> sets, int componentType);

// Whether the numbers are read as they are when they have been written so.
bool holdsExactly(const Table& table, const Encoding& encoding);

}  // namespace remesher::io
