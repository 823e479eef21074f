// SPDX-License-Identifier: MIT
#include "io/gltf/tree/gltf_extensions.h"

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <utility>

#include "base/legible.h"

namespace remesher::io {
namespace {

constexpr std::string_view kRestart = "KHR_mesh_primitive_restart";
constexpr std::string_view kQuantization = "KHR_mesh_quantization";
constexpr const char* kVariants = "KHR_materials_variants";

// The fate of an extension when its primitive, mesh or accessor is made anew.
enum class Fate {
  Untouched,  // says nothing of vertices and triangles
  Followed,   // names attributes, or textures and texture coordinates: stays if these do
  Dropped,    // refers to vertices or triangles by number
  Judged,     // unknown: dropped if it holds an integer
};

struct Row {
  std::string_view beginning;  // of the name; the first matching row counts
  Fate fate;
  Hidden hidden;
};

constexpr Row kRows[] = {
    {"ADOBE_materials_", Fate::Untouched, Hidden::Nothing},
    {"CESIUM_mesh_vector", Fate::Dropped, Hidden::Anything},
    {"CESIUM_primitive_outline", Fate::Dropped, Hidden::Anything},
    {"CESIUM_tile_edges", Fate::Dropped, Hidden::Anything},
    {"EXT_feature_metadata", Fate::Followed, Hidden::Anything},
    {"EXT_lights_image_based", Fate::Untouched, Hidden::Looks},
    {"EXT_materials_", Fate::Untouched, Hidden::Nothing},
    {"EXT_mesh_features", Fate::Followed, Hidden::Looks},
    {"EXT_mesh_gpu_instancing", Fate::Untouched, Hidden::Nothing},
    {"EXT_mesh_manifold", Fate::Dropped, Hidden::Anything},
    {"EXT_mesh_polygon", Fate::Dropped, Hidden::Anything},
    {"EXT_mesh_primitive_edge_visibility", Fate::Dropped, Hidden::Anything},
    {"EXT_mesh_primitive_restart", Fate::Dropped, Hidden::Anything},
    {"EXT_structural_metadata", Fate::Followed, Hidden::Anything},
    {"EXT_texture_", Fate::Untouched, Hidden::Nothing},
    {"FB_ngon_encoding", Fate::Dropped, Hidden::Nothing},
    {"KHR_animation_pointer", Fate::Untouched, Hidden::Nothing},
    {"KHR_lights_punctual", Fate::Untouched, Hidden::Nothing},
    {"KHR_lights_", Fate::Untouched, Hidden::Looks},
    {"KHR_materials_", Fate::Untouched, Hidden::Nothing},
    {"KHR_mesh_quantization", Fate::Untouched, Hidden::Nothing},
    {"KHR_node_", Fate::Untouched, Hidden::Nothing},
    {"KHR_texture_", Fate::Untouched, Hidden::Nothing},
    {"KHR_xmp", Fate::Untouched, Hidden::Nothing},
    {"MAXAR_mesh_variants", Fate::Untouched, Hidden::Nothing},
    {"MPEG_mesh_linking", Fate::Dropped, Hidden::Anything},
    {"MSFT_lod", Fate::Untouched, Hidden::Nothing},
    {"MSFT_packing_", Fate::Untouched, Hidden::Nothing},
    {"MSFT_texture_dds", Fate::Untouched, Hidden::Nothing},
    {"VRMC_materials_", Fate::Untouched, Hidden::Nothing},
    {"VRMC_springBone", Fate::Untouched, Hidden::Nothing},
    {"VRM", Fate::Untouched, Hidden::Looks},
    {"", Fate::Judged, Hidden::Anything},
};

const Row& rowOf(std::string_view extension) {
  return *std::find_if(std::begin(kRows), std::end(kRows),
                       [&](const Row& row) { return extension.starts_with(row.beginning); });
}

template <class Visit>
void forEachWholeNumber(const Json& value, const Visit& visit) {
  if (isWholeNumber(value)) visit(value.get<std::uint64_t>());
  if (!value.is_structured()) return;
  for (const Json& member : value) forEachWholeNumber(member, visit);
}

bool holdsWholeNumber(const Json& value) {
  bool holds = false;
  forEachWholeNumber(value, [&](std::uint64_t) { holds = true; });
  return holds;
}

// The element of a list in the tree's root extension that a primitive's extension refers to, by
// number or by name.
const Json* inRoot(const Json& tree, const std::string& extension, const std::string& list,
                   const Json& reference) {
  const Json::json_pointer path("/extensions/" + extension + "/" + list);
  if (!tree.contains(path)) return nullptr;
  const Json& all = tree[path];
  if (all.is_array() && isWholeNumber(reference) && reference.get<std::uint64_t>() < all.size())
    return &all[reference.get<std::size_t>()];
  if (all.is_object() && reference.is_string() && all.contains(reference.get<std::string>()))
    return &all[reference.get<std::string>()];
  return nullptr;
}

// Finds references to attributes and textures that no longer exist.
class StaleFinder {
 public:
  StaleFinder(const Json& tree, const Json& primitive, Texcoords texcoords)
      : tree_(tree), attributes_(primitive["attributes"]), texcoords_(texcoords) {}

  // value: the key's value, or one element of the key's list.
  bool isStale(const std::string& extension, const std::string& key, const Json& value) const {
    if (key == "propertyTextures" || key == "propertyAttributes" || key == "featureTextures") {
      const Json* const named = inRoot(tree_, extension, key, value);
      return named != nullptr && isStale(*named);
    }
    return (key == "featureIds" && countsVertices(value)) || isStale(value);
  }

 private:
  // Identifiers without a source number the vertices in order.
  static bool countsVertices(const Json& ids) {
    return ids.is_object() && !ids.contains("attribute") && !ids.contains("texture");
  }

  bool isStale(const Json& value) const {
    if (!value.is_structured()) return false;
    if (value.is_object()) {
      if (value.contains("index") && isWholeNumber(value["index"])) return isStaleTexture(value);
      if (value.contains("divisor") && value["divisor"] != 0) return true;  // by vertex number
      if (value.contains("attribute") && isStaleAttribute(value["attribute"])) return true;
    }
    return std::any_of(value.begin(), value.end(), [&](const Json& m) { return isStale(m); });
  }

  bool isStaleTexture(const Json& texture) const {
    const Json set = texture.value("texCoord", Json(0U));
    return texcoords_ == Texcoords::Painted || !isWholeNumber(set) ||
           !attributes_.contains("TEXCOORD_" + set.dump());
  }

  bool isStaleAttribute(const Json& attribute) const {
    if (attribute.is_string()) return !attributes_.contains(attribute.get<std::string>());
    return isWholeNumber(attribute) && !attributes_.contains("_FEATURE_ID_" + attribute.dump());
  }

  const Json& tree_;
  const Json& attributes_;
  Texcoords texcoords_;
};

void lose(const std::string& name, const Json& extension, LostExtensions& lost) {
  ++lost.count[name];
  forEachWholeNumber(extension, [&](std::uint64_t number) {
    constexpr std::uint64_t kMost = 0x7FFFFFFF;
    if (number <= kMost) lost.accessors.insert(static_cast<int>(number));
  });
}

// Calls keep(name, extension) for each extension of the holder; drops it if the result is false.
template <class Keep>
void settle(Json& holder, LostExtensions& lost, const Keep& keep) {
  if (!holder.contains("extensions") || !holder["extensions"].is_object()) return;
  std::vector<std::string> gone;
  for (auto& [name, extension] : holder["extensions"].items())
    if (!keep(name, extension)) gone.push_back(name);
  for (const std::string& name : gone) {
    lose(name, holder["extensions"][name], lost);
    holder["extensions"].erase(name);
  }
  if (holder["extensions"].empty()) holder.erase("extensions");
}

bool isKept(const std::string& name, const Json& extension) {
  const Fate fate = rowOf(name).fate;
  if (fate == Fate::Judged) return !holdsWholeNumber(extension);
  return fate != Fate::Dropped;
}

// The value without its stale elements; null if nothing is left.
Json freshIn(const Json& value, const std::function<bool(const Json&)>& isStale) {
  if (!value.is_array()) return isStale(value) ? Json() : value;
  Json fresh = Json::array();
  for (const Json& one : value)
    if (!isStale(one)) fresh.push_back(one);
  return fresh.empty() && !value.empty() ? Json() : fresh;
}

// Removes stale references; returns whether anything is left.
bool follow(const StaleFinder& finder, const std::string& name, Json& extension,
            LostExtensions& lost) {
  if (!extension.is_object()) return false;
  Json left = Json::object();
  for (const auto& [member, value] : extension.items()) {
    const std::string& key = member;
    Json fresh = freshIn(value, [&](const Json& one) { return finder.isStale(name, key, one); });
    if (!fresh.is_null()) left[key] = std::move(fresh);
  }
  if (left.empty()) return extension.empty();
  if (left != extension) ++lost.count[name];
  extension = std::move(left);
  return true;
}

// The names of all extensions below the value.
void collectNames(const Json& value, std::set<std::string>& names) {
  if (!value.is_structured()) return;
  if (value.is_object() && value.contains("extensions") && value["extensions"].is_object())
    for (const auto& [name, extension] : value["extensions"].items()) names.insert(name);
  for (const Json& member : value) collectNames(member, names);
}

template <class Visit>
void forEachPrimitive(const Json& tree, const Visit& visit) {
  if (!tree.contains("meshes")) return;
  for (const Json& mesh : tree["meshes"])
    if (mesh.contains("primitives"))
      for (const Json& primitive : mesh["primitives"]) visit(primitive);
}

// Whether core glTF does not allow this attribute the accessor's component type.
bool isQuantized(const Json& tree, const std::string& semantic, const Json& number) {
  constexpr int kUnsignedByte = 5121, kUnsignedShort = 5123, kFloat = 5126;
  if (!isWholeNumber(number) || number.get<std::uint64_t>() >= tree["accessors"].size())
    return false;
  const Json& accessor = tree["accessors"][number.get<std::size_t>()];
  const int type = accessor.value("componentType", kFloat);
  if (type == kFloat) return false;
  if (semantic == "POSITION" || semantic == "NORMAL" || semantic == "TANGENT") return true;
  return semantic.starts_with("TEXCOORD_") && !((type == kUnsignedByte || type == kUnsignedShort) &&
                                                accessor.value("normalized", false));
}

bool needsQuantization(const Json& tree) {
  bool needs = false;
  const auto look = [&](const Json& attributes) {
    for (const auto& [semantic, number] : attributes.items())
      needs = needs || isQuantized(tree, semantic, number);
  };
  forEachPrimitive(tree, [&](const Json& primitive) {
    look(primitive.value("attributes", Json::object()));
    for (const Json& target : primitive.value("targets", Json::array())) look(target);
  });
  return needs;
}

bool needsRestart(const Json& tree) {
  constexpr std::array kModes = {2, 3, 5, 6};
  bool needs = false;
  forEachPrimitive(tree, [&](const Json& primitive) {
    const Json mode = primitive.value("mode", Json(4));
    const bool isStrip = std::find(kModes.begin(), kModes.end(), mode) != kModes.end();
    const bool hasLoops =
        primitive.value("extensions", Json::object()).contains("EXT_mesh_polygon");
    needs = needs || hasLoops || (isStrip && primitive.contains("indices"));
  });
  return needs;
}

}  // namespace

void settlePrimitive(const Json& tree, Json& primitive, Texcoords texcoords, LostExtensions& lost) {
  const StaleFinder finder(tree, primitive, texcoords);
  settle(primitive, lost, [&](const std::string& name, Json& extension) {
    return rowOf(name).fate == Fate::Followed ? follow(finder, name, extension, lost)
                                              : isKept(name, extension);
  });
}

void settleHolder(Json& holder, LostExtensions& lost) {
  settle(holder, lost,
         [](const std::string& name, const Json& extension) { return isKept(name, extension); });
}

std::vector<Warning> warningsOf(const LostExtensions& lost) {
  if (lost.count.empty()) return {};
  std::vector<std::string> names;
  std::size_t count = 0;
  for (const auto& [name, times] : lost.count) {
    names.push_back(name);
    count += times;
  }
  return {{"EXTENSION_NOT_CARRIED",
           "What " + legibleList(names) +
               " says of triangles, vertices or textures that are made anew is dropped.",
           count}};
}

void dropUnusedVariants(Json& tree) {
  bool isUsed = false;
  forEachPrimitive(tree, [&](const Json& primitive) {
    isUsed = isUsed || primitive.value("extensions", Json::object()).contains(kVariants);
  });
  if (isUsed || !tree.contains("extensions") || !tree["extensions"].is_object()) return;
  tree["extensions"].erase(kVariants);
  if (tree["extensions"].empty()) tree.erase("extensions");
}

void settleDeclarations(const Json& before, Json& tree) {
  std::set<std::string> was, is;
  collectNames(before, was);
  collectNames(tree, is);
  const bool quantizes = needsQuantization(tree), restarts = needsRestart(tree);
  const auto isNeedless = [&](const Json& name) {
    if (!name.is_string()) return true;
    if (name == kQuantization) return !quantizes;
    if (name == kRestart) return !restarts;
    if (is.contains(name)) return false;
    const Fate fate = rowOf(name.get_ref<const std::string&>()).fate;
    return was.contains(name) || fate == Fate::Dropped || fate == Fate::Followed;
  };
  for (const char* list : {"extensionsUsed", "extensionsRequired"}) {
    if (!tree.contains(list) || !tree[list].is_array()) continue;
    Json needed = Json::array();
    for (const Json& name : tree[list])
      if (!isNeedless(name)) needed.push_back(name);
    if (needed.empty())
      tree.erase(list);
    else
      tree[list] = std::move(needed);
  }
  // A required extension is also used, even if a broken file does not say so.
  if (tree.contains("extensionsRequired") && !tree.contains("extensionsUsed"))
    tree["extensionsUsed"] = tree["extensionsRequired"];
}

Hidden hiddenIn(std::string_view extension) { return rowOf(extension).hidden; }

std::string requiredUnknown(const Json& tree) {
  const Json required = tree.is_object() ? tree.value("extensionsRequired", Json::array()) : Json();
  if (!required.is_array()) return {};
  for (const Json& name : required) {
    if (!name.is_string() || name == kRestart) continue;
    if (rowOf(name.get_ref<const std::string&>()).fate == Fate::Judged)
      return name.get<std::string>();
  }
  return {};
}

bool restartsPrimitives(const Json& tree) {
  const Json used = tree.value("extensionsUsed", Json::array());
  return std::find(used.begin(), used.end(), kRestart) != used.end();
}

}  // namespace remesher::io
