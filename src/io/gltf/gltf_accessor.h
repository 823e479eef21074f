// SPDX-License-Identifier: MIT
// The values of accessors of any component type and layout: interleaved, sparse, normalised,
// without a buffer view. Every range is checked before a byte is read. Each function throws
// PARSE_ERROR with the accessor's number if the accessor promises data that is not there.
#pragma once

#include <optional>
#include <vector>

#include "base/triangle_mesh.h"
#include "base/types.h"
#include "io/gltf/gltf_document.h"

namespace remesher::io {

// How the values of an accessor are stored.
struct Encoding {
  int componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
  bool normalized = false;
  int components = 1;  // 1 to 4, or 4, 9, 16 of a matrix

  bool operator==(const Encoding&) const = default;
};

// The largest value of an integer type, to which 1 is normalised. 0 for floats.
double largestInteger(int componentType);
std::size_t componentSize(int componentType);

// None for floats. A signed normalised integer is never below minus its largest value.
std::optional<WholeSteps> wholeStepsOf(const Encoding& encoding);

std::size_t accessorCount(const GltfDocument& document, int accessor);
Encoding accessorEncoding(const GltfDocument& document, int accessor);

// `count` must be the accessor's count. Normalised integers become fractions.
std::vector<float> readFloats(const GltfDocument& document, int accessor, std::size_t count);

// The values of an index accessor. The caller must check that the vertices exist.
std::vector<Index> readIndices(const GltfDocument& document, int accessor);

}  // namespace remesher::io
