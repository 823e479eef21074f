// SPDX-License-Identifier: MIT
#include "io/gltf/gltf_accessor.h"

#include <algorithm>
#include <limits>
#include <string>

#include "io/model/byte_reader.h"

namespace remesher::io {
namespace {

// Elements in a file, one every `stride` bytes.
struct Elements {
  const File& file;
  std::uint64_t begin;
  std::size_t stride;
  std::size_t count;
};

struct ElementRange {
  int bufferView;
  std::size_t byteOffset;
  std::size_t count;
  std::size_t size;
};

class AccessorReader {
 public:
  AccessorReader(const GltfDocument& document, int number);

  const tinygltf::Accessor& accessor() const { return accessor_; }
  const Encoding& encoding() const { return encoding_; }
  std::vector<float> floats() const;
  std::vector<Index> indices() const;

 private:
  [[noreturn]] void fail(const std::string& what) const;
  Elements locate(const ElementRange& range) const;
  std::size_t elementSize() const;
  template <class Value>
  std::vector<Value> values() const;
  template <class Value>
  void applySparse(std::vector<Value>& values) const;

  const GltfDocument& document_;
  int number_;
  const tinygltf::Accessor& accessor_;
  Encoding encoding_;
};

const tinygltf::Accessor& accessorAt(const GltfDocument& document, int number) {
  if (number < 0 || static_cast<std::size_t>(number) >= document.typed.accessors.size())
    document.fail(ErrorCode::ParseError,
                  "it refers to accessor " + std::to_string(number) + ", which is not there.");
  return document.typed.accessors[number];
}

AccessorReader::AccessorReader(const GltfDocument& document, int number)
    : document_(document), number_(number), accessor_(accessorAt(document, number)) {
  encoding_ = {accessor_.componentType, accessor_.normalized,
               tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor_.type))};
  if (componentSize(encoding_.componentType) == 0) fail("has a component type glTF does not know");
}

void AccessorReader::fail(const std::string& what) const {
  document_.fail(ErrorCode::ParseError, "accessor " + std::to_string(number_) + " " + what + ".",
                 "The file is damaged: export it again.");
}

std::size_t AccessorReader::elementSize() const {
  return componentSize(encoding_.componentType) * static_cast<std::size_t>(encoding_.components);
}

Elements AccessorReader::locate(const ElementRange& range) const {
  const auto& views = document_.typed.bufferViews;
  if (range.bufferView < 0 || static_cast<std::size_t>(range.bufferView) >= views.size())
    fail("refers to a buffer view that is not there");
  const tinygltf::BufferView& view = views[range.bufferView];
  const GltfBuffer& buffer = document_.buffers[view.buffer];
  const std::size_t stride = view.byteStride == 0 ? range.size : view.byteStride;
  if (stride < range.size) fail("has elements larger than their stride");
  if (range.count == 0) return {*buffer.file, 0, stride, 0};
  const bool isInside =
      range.byteOffset <= view.byteLength && range.size <= view.byteLength - range.byteOffset &&
      (range.count - 1) <= (view.byteLength - range.byteOffset - range.size) / stride;
  if (!isInside) fail("reaches beyond its buffer view");
  return {*buffer.file, buffer.begin + view.byteOffset + range.byteOffset, stride, range.count};
}

// Calls `action` with a value of the C++ type of the component type.
template <class Action>
void withComponentType(int componentType, const Action& action) {
  switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return action(std::int8_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return action(std::uint8_t{});
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return action(std::int16_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return action(std::uint16_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return action(std::uint32_t{});
    default:
      return action(float{});
  }
}

template <class Value, class Component>
Value converted(Component component, bool isNormalized) {
  if constexpr (std::is_integral_v<Component> && std::is_floating_point_v<Value>) {
    constexpr auto kOne = static_cast<float>(std::numeric_limits<Component>::max());
    // The most negative integer is one step below -1.
    if (isNormalized) return std::max(static_cast<float>(component) / kOne, -1.0F);
  }
  return static_cast<Value>(component);
}

// The numbers of all elements in order, converted from their stored type.
template <class Value>
std::vector<Value> decoded(const Elements& elements, const Encoding& encoding) {
  const auto width = static_cast<std::size_t>(encoding.components);
  std::vector<Value> values(elements.count * width);
  ByteReader reader(elements.file);
  reader.goTo(elements.begin);
  withComponentType(encoding.componentType, [&]<class Component>(Component) {
    const std::size_t size = width * sizeof(Component);
    for (std::size_t i = 0; i < elements.count; ++i) {
      if (i > 0 && elements.stride > size) reader.next(elements.stride - size);
      const std::uint8_t* const element = reader.next(size);
      for (std::size_t k = 0; k < width; ++k)
        values[i * width + k] = converted<Value>(
            littleEndianAt<Component>(element + k * sizeof(Component)), encoding.normalized);
    }
  });
  return values;
}

template <class Value>
std::vector<Value> AccessorReader::values() const {
  std::vector<Value> values;
  if (accessor_.bufferView >= 0)
    values = decoded<Value>(
        locate({accessor_.bufferView, accessor_.byteOffset, accessor_.count, elementSize()}),
        encoding_);
  else
    values.resize(accessor_.count * static_cast<std::size_t>(encoding_.components));
  if (accessor_.sparse.isSparse) applySparse(values);
  return values;
}

// A sparse accessor replaces some elements: a list of their numbers, and a list of their values.
template <class Value>
void AccessorReader::applySparse(std::vector<Value>& values) const {
  const auto& sparse = accessor_.sparse;
  // Offsets are int in tinygltf 2.7; sizes are size_t in 2.9, where negative numbers wrap around.
  const auto isNegative = [](std::int64_t number) { return number < 0; };
  if (isNegative(sparse.count) || isNegative(sparse.indices.byteOffset) ||
      isNegative(sparse.values.byteOffset))
    fail("has a malformed sparse part");
  const auto count = static_cast<std::size_t>(sparse.count);
  const std::size_t indexSize = componentSize(sparse.indices.componentType);
  if (indexSize == 0 || sparse.indices.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT)
    fail("has sparse indices of no integer type");
  const std::vector<Index> numbers = decoded<Index>(
      locate({sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset), count,
              indexSize}),
      {sparse.indices.componentType, false, 1});
  const std::vector<Value> replacements = decoded<Value>(
      locate({sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset), count,
              elementSize()}),
      encoding_);
  const auto width = static_cast<std::ptrdiff_t>(encoding_.components);
  for (std::size_t i = 0; i < count; ++i) {
    if (numbers[i] >= accessor_.count) fail("has a sparse index beyond its end");
    std::copy_n(replacements.begin() + static_cast<std::ptrdiff_t>(i) * width, width,
                values.begin() + static_cast<std::ptrdiff_t>(numbers[i]) * width);
  }
}

std::vector<float> AccessorReader::floats() const { return values<float>(); }

std::vector<Index> AccessorReader::indices() const {
  const bool isInteger = encoding_.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                         encoding_.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                         encoding_.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  if (!isInteger || encoding_.components != 1)
    fail("holds indices, but is not of unsigned integers");
  return values<Index>();
}

}  // namespace

double largestInteger(int componentType) {
  double largest = 0;
  withComponentType(componentType, [&]<class Component>(Component) {
    if constexpr (std::is_integral_v<Component>)
      largest = static_cast<double>(std::numeric_limits<Component>::max());
  });
  return largest;
}

std::optional<WholeSteps> wholeStepsOf(const Encoding& encoding) {
  std::optional<WholeSteps> steps;
  withComponentType(encoding.componentType, [&]<class Component>(Component) {
    using Limits = std::numeric_limits<Component>;
    if constexpr (std::is_integral_v<Component>) {
      const auto highest = static_cast<double>(Limits::max());
      const bool isBelowRange = encoding.normalized && Limits::is_signed;
      steps = {encoding.normalized ? highest : 1,
               isBelowRange ? -highest : static_cast<double>(Limits::lowest()), highest};
    }
  });
  return steps;
}

std::size_t componentSize(int componentType) {
  switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    default:
      return 0;
  }
}

// An accessor without a buffer view is all zeros and may claim any count. No real one has more
// elements than the file has bytes.
std::size_t accessorCount(const GltfDocument& document, int accessor) {
  const std::size_t count = accessorAt(document, accessor).count;
  if (count > document.bufferBytes)
    document.fail(ErrorCode::ParseError,
                  "accessor " + std::to_string(accessor) + " claims " + std::to_string(count) +
                      " elements, more than the file can hold.",
                  "Was it copied completely?");
  return count;
}

Encoding accessorEncoding(const GltfDocument& document, int accessor) {
  return AccessorReader(document, accessor).encoding();
}

std::vector<float> readFloats(const GltfDocument& document, int accessor, std::size_t count) {
  const AccessorReader reader(document, accessor);
  if (reader.accessor().count != count)
    document.fail(ErrorCode::ParseError,
                  "accessor " + std::to_string(accessor) + " has " +
                      std::to_string(reader.accessor().count) + " elements, but there are " +
                      std::to_string(count) + " vertices.",
                  "The file is damaged: export it again.");
  return reader.floats();
}

std::vector<Index> readIndices(const GltfDocument& document, int accessor) {
  accessorCount(document, accessor);
  return AccessorReader(document, accessor).indices();
}

}  // namespace remesher::io
