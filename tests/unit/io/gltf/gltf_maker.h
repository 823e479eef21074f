// SPDX-License-Identifier: MIT
// glTF files made by the tests that read them: values in, a GLB, a .gltf with its .bin, or one with
// a data URI out.
#pragma once

#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/file.h"
#include "io/gltf/gltf_document.h"
#include "io/model/resources.h"

namespace remesher::test {

using io::Bytes;
using io::Json;

enum ComponentType { kByte = 5120, kUByte, kShort, kUShort, kUInt = 5125, kFloat };

template <class Value>
Bytes bytesOf(const std::vector<Value>& values) {
  Bytes bytes(values.size() * sizeof(Value));
  std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

struct GltfMaker {
  Json tree = {{"asset", {{"version", "2.0"}}}};
  Bytes data;

  int addView(const Bytes& bytes, int stride = 0) {
    data.resize((data.size() + 3) / 4 * 4, 0);
    Json view = {{"buffer", 0}, {"byteOffset", data.size()}, {"byteLength", bytes.size()}};
    if (stride != 0) view["byteStride"] = stride;
    tree["bufferViews"].push_back(view);
    data.insert(data.end(), bytes.begin(), bytes.end());
    return static_cast<int>(tree["bufferViews"].size()) - 1;
  }

  // description: componentType, count, type and whatever else an accessor may say.
  int addAccessor(const Json& description) {
    tree["accessors"].push_back(description);
    return static_cast<int>(tree["accessors"].size()) - 1;
  }

  template <class Value>
  int add(const std::vector<Value>& values, int componentType, const std::string& type) {
    const int width = type == "SCALAR" ? 1 : type.back() - '0';
    return addAccessor({{"bufferView", addView(bytesOf(values))},
                        {"componentType", componentType},
                        {"count", values.size() / static_cast<std::size_t>(width)},
                        {"type", type}});
  }

  int addNormalized(const Bytes& bytes, int componentType, const std::string& type) {
    const int accessor = add(bytes, componentType, type);
    tree["accessors"][accessor]["normalized"] = true;
    return accessor;
  }

  int addMesh(const std::vector<Json>& primitives) {
    tree["meshes"].push_back({{"primitives", primitives}});
    return static_cast<int>(tree["meshes"].size()) - 1;
  }

  // A scene that shows these nodes.
  void show(const std::vector<Json>& nodes) {
    Json roots = Json::array();
    for (std::size_t i = 0; i < nodes.size(); ++i) roots.push_back(i);
    tree["nodes"] = nodes;
    tree["scenes"] = Json::array({Json{{"nodes", roots}}});
    tree["scene"] = 0;
  }

  Json withBuffer(const std::string& uri) const {
    Json complete = tree;
    Json buffer = {{"byteLength", data.size()}};
    if (!uri.empty()) buffer["uri"] = uri;
    complete["buffers"] = Json::array({buffer});
    return complete;
  }

  File glb() const { return {"made.glb", io::packGlb(withBuffer(""), data)}; }

  File gltf(const std::string& uri) const {
    const std::string text = withBuffer(uri).dump();
    return {"made.gltf", {text.begin(), text.end()}};
  }

  File embedded() const { return gltf(io::encodeDataUri("application/octet-stream", data)); }
};

inline Json treeOf(const File& glb) { return io::openGltf(glb, {})->tree; }

// The corners of a unit square, and its two triangles.
inline const std::vector<float> kSquarePositions = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
inline const std::vector<std::uint16_t> kSquareIndices = {0, 1, 2, 0, 2, 3};

}  // namespace remesher::test
