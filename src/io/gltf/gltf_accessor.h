// SPDX-License-Identifier: MIT
// The values of accessors, whatever their component type and layout: interleaved, sparse,
// normalised, without a buffer view. Every range is checked before a byte is read.
// Each function throws PARSE_ERROR naming the accessor if it promises what is not there.
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

// The largest value of an integer type: what 1 becomes when normalised. 0 for floats.
double largestInteger(int componentType);
std::size_t componentSize(int componentType);

// None for floats. A normalised integer is never less than minus its largest.
std::optional<WholeSteps> wholeStepsOf(const Encoding& encoding);

std::size_t accessorCount(const GltfDocument& document, int accessor);
Encoding accessorEncoding(const GltfDocument& document, int accessor);

// `count` is what the accessor's must be. Normalised integers become fractions.
std::vector<float> readFloats(const GltfDocument& document, int accessor, std::size_t count);

// The values of an index accessor; whether the vertices exist is for the caller to check.
std::vector<Index> readIndices(const GltfDocument& document, int accessor);

}  // namespace remesher::io
