// SPDX-License-Identifier: MIT
#include "io/gltf/gltf_materials.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "io/gltf/gltf_references.h"
#include "io/gltf/tree/gltf_pointers.h"

namespace remesher::io {
namespace {

constexpr const char* kWebp = "EXT_texture_webp";
constexpr const char* kKtx2 = "KHR_texture_basisu";
constexpr const char* kUnlit = "KHR_materials_unlit";
constexpr const char* kTransform = "KHR_texture_transform";

// A member of a material, which may be of any type: null unless it is an object.
const Json& objectIn(const Json& parent, const char* key) {
  static const Json kNothing = Json::object();
  const auto found = parent.find(key);
  return found != parent.end() && found->is_object() ? *found : kNothing;
}

double numberIn(const Json& parent, const char* key, double otherwise) {
  const auto found = parent.find(key);
  return found != parent.end() && found->is_number() ? found->get<double>() : otherwise;
}

template <int n>
Eigen::Matrix<double, n, 1> vectorIn(const Json& parent, const char* key,
                                     Eigen::Matrix<double, n, 1> otherwise) {
  const auto found = parent.find(key);
  if (found == parent.end() || !found->is_array()) return otherwise;
  for (int i = 0; i < n && i < int(found->size()); ++i)
    if ((*found)[i].is_number()) otherwise[i] = (*found)[i].template get<double>();
  return otherwise;
}

const Json& element(const Json& tree, const char* list, const Json& number) {
  static const Json kNothing = Json::object();
  const auto found = tree.find(list);
  if (found == tree.end() || !number.is_number_integer()) return kNothing;
  const auto i = number.get<std::int64_t>();
  if (i < 0 || std::size_t(i) >= found->size()) return kNothing;
  return (*found)[std::size_t(i)];
}

Wrap wrapOf(const Json& sampler, const char* key) {
  constexpr int kClamp = 33071, kMirror = 33648;
  const int code = int(numberIn(sampler, key, 0));
  return code == kClamp ? Wrap::Clamp : code == kMirror ? Wrap::Mirror : Wrap::Repeat;
}

// The transform of KHR_texture_transform: scale, then rotation, then offset.
Eigen::Matrix<double, 2, 3> transformOf(const Json& extension) {
  const Vec2 offset = vectorIn<2>(extension, "offset", Vec2::Zero());
  const Vec2 scale = vectorIn<2>(extension, "scale", Vec2::Ones());
  const double angle = numberIn(extension, "rotation", 0);
  const double c = std::cos(angle), s = std::sin(angle);
  Eigen::Matrix<double, 2, 3> result;
  result << c * scale.x(), s * scale.y(), offset.x(), -s * scale.x(), c * scale.y(), offset.y();
  return result;
}

// The number of a texture's image: WebP, else the one that every program reads, else KTX2; nothing
// if it has none.
Json sourceOf(const Json& texture) {
  const Json& extensions = objectIn(texture, "extensions");
  for (const Json* holder : {&objectIn(extensions, kWebp), &texture, &objectIn(extensions, kKtx2)})
    if (holder->contains("source")) return (*holder)["source"];
  return {};
}

// parent: the object whose member `key` is the reference to a texture.
Map mapIn(const Json& tree, const Json& parent, const char* key) {
  const Json& info = objectIn(parent, key);
  if (!info.contains("index")) return {};
  const Json& texture = element(tree, "textures", info["index"]);
  const Json source = sourceOf(texture);
  Map map;
  if (!source.is_number_integer()) return map;
  map.image = std::to_string(source.get<std::int64_t>());
  const Json& extension = objectIn(objectIn(info, "extensions"), kTransform);
  map.texcoord = int(numberIn(extension, "texCoord", numberIn(info, "texCoord", 0)));
  map.transform = transformOf(extension);
  const Json& sampler = element(tree, "samplers", texture.value("sampler", Json()));
  map.wrap = {wrapOf(sampler, "wrapS"), wrapOf(sampler, "wrapT")};
  return map;
}

bool isTextureInfo(const Json& value) { return value.is_object() && value.contains("index"); }

// Collects the maps of extensions: the key of every object with a texture's number.
void collectMaps(const Json& value, std::vector<std::string>& names) {
  if (!value.is_structured()) return;
  for (const auto& [key, member] : value.items())
    if (isTextureInfo(member))
      names.push_back(key);
    else
      collectMaps(member, names);
}

void removeMaps(Json& value) {
  if (!value.is_structured()) return;
  std::vector<std::string> keys;
  for (auto& [key, member] : value.items())
    if (value.is_object() && isTextureInfo(member))
      keys.push_back(key);
    else
      removeMaps(member);
  for (const std::string& key : keys) value.erase(key);
}

// A material says nothing with these: some exporters write them, others do not.
void dropDefaults(Json& material) {
  const auto drop = [&](const char* key, const Json& usual) {
    if (material.contains(key) && material[key] == usual) material.erase(key);
  };
  drop("alphaMode", "OPAQUE");
  drop("alphaCutoff", 0.5);
  drop("doubleSided", false);
  drop("extensions", Json::object());
  drop("extras", Json::object());
}

// The material without its name and everything that can be painted.
Json restOf(Json material) {
  for (const char* key : {"name", "pbrMetallicRoughness", "normalTexture", "occlusionTexture",
                          "emissiveTexture", "emissiveFactor"})
    material.erase(key);
  dropDefaults(material);
  return material;
}

template <int n>
Json listOf(const Eigen::Matrix<double, n, 1>& vector) {
  return std::vector<double>(vector.data(), vector.data() + n);
}

// Adds the texture of a painted map; returns the reference to it.
Json textureInfo(Json& tree, const Model& model, const Map& map) {
  const std::size_t number = std::stoul(map.image);
  const PaintedImage& painted = model.images[number];
  const std::string uri = "painting:" + map.image;
  for (const char* list : {"images", "textures"})
    if (!tree.contains(list)) tree[list] = Json::array();
  Json& images = tree["images"];
  Json& textures = tree["textures"];
  for (std::size_t i = 0; i < textures.size(); ++i) {
    if (element(tree, "images", sourceOf(textures[i])).value("uri", "") == uri)
      return {{"index", i}};
  }
  images.push_back({{"name", painted.name}, {"mimeType", painted.type}, {"uri", uri}});
  const std::size_t image = images.size() - 1;
  if (painted.type == "image/webp")
    textures.push_back({{"extensions", {{kWebp, {{"source", image}}}}}});
  else
    textures.push_back({{"source", image}});
  return {{"index", textures.size() - 1}};
}

void addName(Json& names, const char* name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

// Drops MSFT_lod's materials for a distance, which use the old textures.
void dropLevels(Json& material) {
  if (!material.contains("extensions") || !material["extensions"].is_object()) return;
  material["extensions"].erase("MSFT_lod");
  if (material["extensions"].empty()) material.erase("extensions");
}

// The fields of a material of another file beside its maps and without extensions that tell of more
// than how its surface is lit.
Json plainRestOf(const std::string& rest) {
  const Json all = Json::parse(rest, nullptr, false);
  Json plain = Json::object();
  for (const char* key : {"alphaMode", "alphaCutoff", "doubleSided"})
    if (all.is_object() && all.contains(key)) plain[key] = all[key];
  const Json& extensions = objectIn(all.is_object() ? all : plain, "extensions");
  if (extensions.contains(kUnlit)) plain["extensions"][kUnlit] = extensions[kUnlit];
  return plain;
}

Json paintedMaterial(Json& tree, const Model& model, const Material& painting) {
  Json material = painting.number < 0 ? Json::object() : tree["materials"][painting.number];
  const std::string name = material.value("name", painting.name);
  material = restOf(std::move(material));
  removeMaps(material);
  dropLevels(material);
  if (!name.empty()) material["name"] = name;
  if (painting.number < 0 && !painting.isOpaque) material["alphaMode"] = "BLEND";
  if (painting.number < 0 && painting.keepsRest) material.update(plainRestOf(painting.rest));
  Json pbr = Json::object();
  if (!painting.baseColor.isOnes()) pbr["baseColorFactor"] = listOf<4>(painting.baseColor);
  if (painting.baseColorMap)
    pbr["baseColorTexture"] = textureInfo(tree, model, painting.baseColorMap);
  if (painting.metallic != 1) pbr["metallicFactor"] = painting.metallic;
  if (painting.roughness != 1) pbr["roughnessFactor"] = painting.roughness;
  if (painting.metalRoughMap)
    pbr["metallicRoughnessTexture"] = textureInfo(tree, model, painting.metalRoughMap);
  material["pbrMetallicRoughness"] = std::move(pbr);
  if (painting.normalMap) material["normalTexture"] = textureInfo(tree, model, painting.normalMap);
  if (painting.occlusionMap)
    material["occlusionTexture"] = textureInfo(tree, model, painting.occlusionMap);
  if (painting.emissiveMap)
    material["emissiveTexture"] = textureInfo(tree, model, painting.emissiveMap);
  if (!painting.emissive.isZero()) material["emissiveFactor"] = listOf<3>(painting.emissive);
  return material;
}

using Visitor = std::function<void(Json& number)>;

void forEachMaterialNumber(Json& tree, const Visitor& visit) {
  for (Json& mesh : tree["meshes"])
    for (Json& primitive : mesh["primitives"]) {
      if (primitive.contains("material")) visit(primitive["material"]);
      if (!primitive.contains("extensions")) continue;
      Json& variants = primitive["extensions"]["KHR_materials_variants"];
      if (variants.is_null())
        primitive["extensions"].erase("KHR_materials_variants");
      else
        for (Json& mapping : variants["mappings"]) visit(mapping["material"]);
    }
  forEachMaterialPointer(tree, visit);
  if (!tree.contains("materials")) return;
  for (Json& material : tree["materials"]) {
    const Json::json_pointer levels("/extensions/MSFT_lod/ids");
    if (!material.contains(levels)) continue;
    for (Json& number : material[levels]) visit(number);
  }
}

void forEachTextureNumberIn(Json& value, const Visitor& visit) {
  if (!value.is_structured()) return;
  for (auto& [key, member] : value.items())
    if (isTextureInfo(member))
      visit(member["index"]);
    else
      forEachTextureNumberIn(member, visit);
}

void forEachImageNumber(Json& tree, const Visitor& visit) {
  for (Json& texture : tree["textures"]) {
    if (texture.contains("source")) visit(texture["source"]);
    if (!texture.contains("extensions")) continue;
    for (auto& [name, extension] : texture["extensions"].items())
      if (extension.is_object() && extension.contains("source")) visit(extension["source"]);
  }
}

void forEachSamplerNumber(Json& tree, const Visitor& visit) {
  for (Json& texture : tree["textures"])
    if (texture.contains("sampler")) visit(texture["sampler"]);
}

// Removes the elements of a list that `forEach` does not visit; returns the removed ones.
std::vector<Json> keepUsed(Json& tree, const char* list,
                           const std::function<void(const Visitor&)>& forEach) {
  if (!tree.contains(list)) return {};
  Json& all = tree[list];
  std::vector<char> used(all.size(), 0);
  forEach([&](Json& number) {
    if (number.is_number_integer() && number.get<std::size_t>() < used.size())
      used[number.get<std::size_t>()] = 1;
  });
  std::vector<std::size_t> numbers;
  std::vector<Json> removed;
  Json kept = Json::array();
  for (std::size_t i = 0; i < all.size(); ++i) {
    numbers.push_back(kept.size());
    if (used[i])
      kept.push_back(std::move(all[i]));
    else
      removed.push_back(std::move(all[i]));
  }
  forEach([&](Json& number) {
    if (number.is_number_integer() && number.get<std::size_t>() < numbers.size())
      number = numbers[number.get<std::size_t>()];
  });
  if (kept.empty())
    tree.erase(list);
  else
    all = std::move(kept);
  return removed;
}

}  // namespace

Material readMaterial(const Json& tree, int number) {
  const Json& json = element(tree, "materials", Json(number));
  const Json& pbr = objectIn(json, "pbrMetallicRoughness");
  Material material;
  material.number = number;
  material.name = json.value("name", "");
  material.baseColor = vectorIn<4>(pbr, "baseColorFactor", Eigen::Vector4d::Ones());
  material.metallic = numberIn(pbr, "metallicFactor", 1);
  material.roughness = numberIn(pbr, "roughnessFactor", 1);
  material.emissive = vectorIn<3>(json, "emissiveFactor", Vec3::Zero());
  material.normalScale = numberIn(objectIn(json, "normalTexture"), "scale", 1);
  material.occlusionStrength = numberIn(objectIn(json, "occlusionTexture"), "strength", 1);
  material.baseColorMap = mapIn(tree, pbr, "baseColorTexture");
  material.metalRoughMap = mapIn(tree, pbr, "metallicRoughnessTexture");
  material.normalMap = mapIn(tree, json, "normalTexture");
  material.occlusionMap = mapIn(tree, json, "occlusionTexture");
  material.emissiveMap = mapIn(tree, json, "emissiveTexture");
  material.isOpaque = json.value("alphaMode", "OPAQUE") == "OPAQUE";
  material.isUnlit = objectIn(json, "extensions").contains(kUnlit);
  const Json rest = restOf(json);
  material.rest = rest.dump(-1, ' ', false, Json::error_handler_t::replace);
  collectMaps(rest, material.unpaintable);
  return material;
}

Json plainMaterial(Material material) {
  material.number = -1;
  for (Map* map : {&material.baseColorMap, &material.metalRoughMap, &material.normalMap,
                   &material.occlusionMap, &material.emissiveMap})
    *map = {};
  Json tree;
  return paintedMaterial(tree, {}, material);
}

std::size_t addPaintings(Json& tree, const Model& model) {
  const std::size_t first = tree.contains("materials") ? tree["materials"].size() : 0;
  bool anyWebp = false;
  for (const Material& painting : model.paintings) {
    Json material = paintedMaterial(tree, model, painting);
    if (objectIn(material, "extensions").contains(kUnlit)) addName(tree["extensionsUsed"], kUnlit);
    tree["materials"].push_back(std::move(material));
  }
  for (const PaintedImage& image : model.images) anyWebp |= image.type == "image/webp";
  if (!anyWebp) return first;
  for (const char* list : {"extensionsUsed", "extensionsRequired"}) addName(tree[list], kWebp);
  return first;
}

std::set<int> dropUnusedLooks(Json& tree) {
  if (mayHideReferences(tree, Named::Look)) return {};
  keepUsed(tree, "materials", [&](const Visitor& v) { forEachMaterialNumber(tree, v); });
  keepUsed(tree, "textures", [&](const Visitor& v) {
    if (tree.contains("materials")) forEachTextureNumberIn(tree["materials"], v);
  });
  const auto images = keepUsed(tree, "images", [&](const Visitor& v) {
    if (tree.contains("textures")) forEachImageNumber(tree, v);
  });
  keepUsed(tree, "samplers", [&](const Visitor& v) {
    if (tree.contains("textures")) forEachSamplerNumber(tree, v);
  });
  std::set<int> views;
  for (const Json& image : images)
    if (image.contains("bufferView")) views.insert(image["bufferView"].get<int>());
  return views;
}

}  // namespace remesher::io
