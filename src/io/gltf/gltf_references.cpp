// SPDX-License-Identifier: MIT
#include "io/gltf/gltf_references.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "io/gltf/tree/gltf_extensions.h"

namespace remesher::io {
namespace {

// Calls the visitor with object[key], if present.
void visitMember(Json& object, const char* key, const NumberVisitor& visit) {
  if (object.is_object() && object.contains(key)) visit(object[key]);
}

void visitEach(Json& object, const char* key, const NumberVisitor& visit) {
  visitMember(object, key, [&](Json& list) {
    if (list.is_structured())
      for (Json& element : list) visit(element);
  });
}

void visitPath(Json& object, std::initializer_list<const char*> path, const NumberVisitor& visit) {
  Json* at = &object;
  for (const char* key : path) {
    if (!at->is_object() || !at->contains(key)) return;
    at = &(*at)[key];
  }
  visit(*at);
}

std::size_t countOf(const Json& tree, const char* list) {
  return tree.contains(list) && tree[list].is_array() ? tree[list].size() : 0;
}

bool hasInteger(const Json& value) {
  if (value.is_number_integer()) return true;
  return value.is_structured() && std::any_of(value.begin(), value.end(), hasInteger);
}

// Whether the value is a JSON pointer to a material, a texture, an image or a sampler.
bool isPointerToLook(const Json& value) {
  if (!value.is_string()) return false;
  const auto& text = value.get_ref<const std::string&>();
  constexpr std::array<std::string_view, 4> kLooks = {"/materials/", "/textures/", "/images/",
                                                      "/samplers/"};
  return std::any_of(kLooks.begin(), kLooks.end(),
                     [&](std::string_view look) { return text.starts_with(look); });
}

bool hasPointerToLook(const Json& value) {
  if (!value.is_structured()) return isPointerToLook(value);
  return std::any_of(value.begin(), value.end(), hasPointerToLook);
}

bool mayHide(const std::string& name, const Json& extension, Named what) {
  const Hidden hidden = hiddenIn(name);
  if (hidden == Hidden::Nothing) return false;
  if (what == Named::Look && hasPointerToLook(extension)) return true;
  return (what == Named::Look || hidden == Hidden::Anything) && hasInteger(extension);
}

NumberVisitor requiredBelow(const GltfDocument& document, std::size_t end,
                            const std::string& what) {
  return [&document, end, what](const Json& number) {
    if (!isWholeNumber(number))
      document.fail(ErrorCode::ParseError, "it refers to " + what + " by what is no number.",
                    "The file is damaged: export it again.");
    if (number.get<std::uint64_t>() >= end)
      document.fail(ErrorCode::ParseError,
                    "it refers to " + what + " " + number.dump() + ", which is not there.",
                    "The file is damaged: export it again.");
  };
}

bool areObjects(const Json& list) {
  return list.is_array() && std::all_of(list.begin(), list.end(),
                                        [](const Json& element) { return element.is_object(); });
}

// Requires valid primitives and targets, because tinygltf skips invalid ones and so numbers the
// following ones differently.
void requirePrimitives(GltfDocument& document) {
  const auto require = [&](bool isSo, const char* message) {
    if (!isSo)
      document.fail(ErrorCode::ParseError, message, "The file is damaged: export it again.");
  };
  visitEach(document.tree, "meshes", [&](Json& mesh) {
    visitEach(mesh, "primitives", [&](const Json& primitive) {
      require(primitive.is_object() && primitive.value("attributes", Json()).is_object(),
              "a primitive of it has no attributes.");
      require(areObjects(primitive.value("targets", Json::array())),
              "its morph targets are no list of attributes.");
    });
  });
}

}  // namespace

void forEachAccessorNumber(Json& tree, const NumberVisitor& visit) {
  visitEach(tree, "meshes", [&](Json& mesh) {
    visitEach(mesh, "primitives", [&](Json& primitive) {
      visitEach(primitive, "attributes", visit);
      visitMember(primitive, "indices", visit);
      visitEach(primitive, "targets", [&](Json& target) {
        for (Json& number : target) visit(number);
      });
    });
  });
  visitEach(tree, "animations", [&](Json& animation) {
    visitEach(animation, "samplers", [&](Json& sampler) {
      visitMember(sampler, "input", visit);
      visitMember(sampler, "output", visit);
    });
  });
  visitEach(tree, "skins", [&](Json& skin) { visitMember(skin, "inverseBindMatrices", visit); });
  visitEach(tree, "nodes", [&](Json& node) {
    visitPath(node, {"extensions", "EXT_mesh_gpu_instancing"},
              [&](Json& instancing) { visitEach(instancing, "attributes", visit); });
  });
}

void forEachBufferViewNumberOf(Json& accessor, const NumberVisitor& visit) {
  visitMember(accessor, "bufferView", visit);
  visitPath(accessor, {"sparse", "indices", "bufferView"}, visit);
  visitPath(accessor, {"sparse", "values", "bufferView"}, visit);
}

void forEachBufferViewNumber(Json& tree, const NumberVisitor& visit) {
  visitEach(tree, "accessors", [&](Json& accessor) { forEachBufferViewNumberOf(accessor, visit); });
  visitEach(tree, "images", [&](Json& image) { visitMember(image, "bufferView", visit); });
}

bool mayHideReferences(const Json& value, Named what) {
  if (!value.is_structured()) return false;
  if (value.is_object() && value.contains("extensions") && value["extensions"].is_object())
    for (const auto& [name, extension] : value["extensions"].items())
      if (mayHide(name, extension, what)) return true;
  return std::any_of(value.begin(), value.end(),
                     [&](const Json& member) { return mayHideReferences(member, what); });
}

void requireReferences(GltfDocument& document) {
  requirePrimitives(document);
  Json& tree = document.tree;
  forEachAccessorNumber(tree, requiredBelow(document, countOf(tree, "accessors"), "accessor"));
  forEachBufferViewNumber(tree,
                          requiredBelow(document, countOf(tree, "bufferViews"), "buffer view"));
}

}  // namespace remesher::io
