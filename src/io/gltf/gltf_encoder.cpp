// SPDX-License-Identifier: MIT
#include "io/gltf/gltf_encoder.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace remesher::io {
namespace {

template <class Component>
Component rounded(float value, bool isNormalized) {
  if constexpr (std::is_floating_point_v<Component>) {
    return value;
  } else {
    constexpr auto kLargest = static_cast<double>(std::numeric_limits<Component>::max());
    const double lowest = isNormalized && std::is_signed_v<Component>
                              ? -kLargest
                              : static_cast<double>(std::numeric_limits<Component>::lowest());
    const double scaled = std::round(isNormalized ? value * kLargest : double{value});
    return static_cast<Component>(std::clamp(scaled, lowest, kLargest));
  }
}

template <class Component>
EncodedAccessor encodeAs(const Table& table, const Encoding& encoding) {
  const auto width = static_cast<std::size_t>(encoding.components);
  EncodedAccessor result;
  result.stride = (width * sizeof(Component) + 3) / 4 * 4;
  result.bytes.resize(result.stride * table.rows(), 0);
  result.min.assign(width, kInfinity);
  result.max.assign(width, -kInfinity);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (std::size_t k = 0; k < width; ++k) {
      const auto value =
          rounded<Component>(table.values[row * table.width + k], encoding.normalized);
      std::memcpy(&result.bytes[row * result.stride + k * sizeof value], &value, sizeof value);
      result.min[k] = std::min(result.min[k], static_cast<double>(value));
      result.max[k] = std::max(result.max[k], static_cast<double>(value));
    }
  }
  return result;
}

template <class Component>
EncodedAccessor encodeIndicesAs(std::span<const Index> indices) {
  EncodedAccessor result;
  result.stride = sizeof(Component);
  result.bytes.resize(indices.size() * sizeof(Component));
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const auto value = static_cast<Component>(indices[i]);
    std::memcpy(&result.bytes[i * sizeof value], &value, sizeof value);
  }
  return result;
}

// Vectors of such a length and weights of such a sum stay as they are, bit for bit.
bool isOne(double x) { return std::abs(x - 1) <= 1e-4; }

}  // namespace

EncodedAccessor encodeRows(const Table& table, const Encoding& encoding) {
  switch (encoding.componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return encodeAs<std::int8_t>(table, encoding);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return encodeAs<std::uint8_t>(table, encoding);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return encodeAs<std::int16_t>(table, encoding);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return encodeAs<std::uint16_t>(table, encoding);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return encodeAs<std::uint32_t>(table, encoding);
    default:
      return encodeAs<float>(table, encoding);
  }
}

int indexType(int wanted, std::size_t vertexCount) {
  if (wanted == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE && vertexCount <= 0xFF) return wanted;
  return vertexCount <= 0xFFFF ? TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT
                               : TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

EncodedAccessor encodeIndices(std::span<const Index> indices, int componentType) {
  switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return encodeIndicesAs<std::uint8_t>(indices);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return encodeIndicesAs<std::uint16_t>(indices);
    default:
      return encodeIndicesAs<std::uint32_t>(indices);
  }
}

void makeUnitLength(Table& table) {
  if (table.width < 3) return;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    Eigen::Map<Eigen::Vector3f> direction(&table.values[row * table.width]);
    const double length = direction.cast<double>().norm();
    if (!(length > 0))
      direction = Eigen::Vector3f::UnitZ();
    else if (!isOne(length))
      direction = (direction.cast<double>() / length).cast<float>();
    if (table.width == 4) {
      float& handedness = table.values[row * 4 + 3];
      handedness = handedness < 0 ? -1.0F : 1.0F;
    }
  }
}

void normalizeWeights(std::span<Table> sets, int componentType) {
  const double one = largestInteger(componentType);
  if (sets.empty()) return;
  for (std::size_t row = 0; row < sets[0].rows(); ++row) {
    std::vector<float*> weights;
    double sum = 0;
    for (Table& set : sets)
      for (int k = 0; k < set.width; ++k) weights.push_back(&set.values[row * set.width + k]);
    for (float* weight : weights) {
      if (one > 0) *weight = static_cast<float>(std::round(std::max(*weight, 0.0F) * one));
      sum += *weight;
    }
    float* const largest = *std::max_element(
        weights.begin(), weights.end(), [](const float* a, const float* b) { return *a < *b; });
    if (one > 0) {
      *largest += static_cast<float>(one - sum);
      for (float* weight : weights) *weight = static_cast<float>(*weight / one);
    } else if (sum == 0) {
      *largest = 1;
    } else if (sum > 0 && !isOne(sum)) {
      for (float* weight : weights) *weight = static_cast<float>(*weight / sum);
    }
  }
}

bool holdsExactly(const Table& table, const Encoding& encoding) {
  const auto steps = wholeStepsOf(encoding);
  if (!steps) return true;
  const auto perUnit = static_cast<float>(steps->perUnit);
  return std::all_of(table.values.begin(), table.values.end(), [&](float value) {
    const double whole = std::round(double{value} * steps->perUnit);
    return whole >= steps->lowest && whole <= steps->highest &&
           static_cast<float>(whole) / perUnit == value;
  });
}

}  // namespace remesher::io
