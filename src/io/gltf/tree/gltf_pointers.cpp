// SPDX-License-Identifier: MIT
#include "io/gltf/tree/gltf_pointers.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace remesher::io {
namespace {

constexpr const char* kPointer = "KHR_animation_pointer";
constexpr const char* kWeights = "animations of morph targets";

// The beginning of a pointer, `/list/number`, and the rest.
struct Pointed {
  std::string list;
  std::size_t number = 0;
  std::string rest;
};

std::optional<Pointed> parsePointer(const Json& value) {
  if (!value.is_string()) return std::nullopt;
  const auto& text = value.get_ref<const std::string&>();
  const std::size_t slash = text.find('/', 1);
  if (text.empty() || text[0] != '/' || slash == std::string::npos) return std::nullopt;
  const std::size_t end = std::min(text.find('/', slash + 1), text.size());
  const std::string digits = text.substr(slash + 1, end - slash - 1);
  constexpr std::size_t kMostDigits = 9;
  if (digits.empty() || digits.size() > kMostDigits ||
      !std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; }))
    return std::nullopt;
  return Pointed{text.substr(1, slash - 1), std::stoul(digits), text.substr(end)};
}

// The pointer of a channel, or null.
Json* pointerOf(Json& channel) {
  const Json::json_pointer path(std::string("/target/extensions/") + kPointer + "/pointer");
  return channel.is_object() && channel.contains(path) ? &channel[path] : nullptr;
}

template <class Visit>
void forEachChannel(Json& tree, const Visit& visit) {
  if (!tree.contains("animations") || !tree["animations"].is_array()) return;
  for (Json& animation : tree["animations"])
    if (animation.is_object() && animation.contains("channels"))
      for (Json& channel : animation["channels"]) visit(channel);
}

template <class Visit>
void forEachNumberOfMaterial(const Json& primitive, const Visit& visit) {
  if (primitive.contains("material")) visit(primitive["material"]);
  const Json::json_pointer mappings("/extensions/KHR_materials_variants/mappings");
  if (!primitive.contains(mappings)) return;
  for (const Json& mapping : primitive[mappings])
    if (mapping.is_object() && mapping.contains("material")) visit(mapping["material"]);
}

// The materials that primitives show, and the meshes with morph targets.
struct Shown {
  std::set<std::size_t> materials, morphed;
};

Shown shownBy(const Json& tree) {
  Shown shown;
  const Json meshes = tree.value("meshes", Json::array());
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    if (!meshes[i].contains("primitives")) continue;
    for (const Json& primitive : meshes[i]["primitives"]) {
      if (!primitive.is_object()) continue;
      if (primitive.contains("targets") && !primitive["targets"].empty()) shown.morphed.insert(i);
      forEachNumberOfMaterial(primitive, [&](const Json& number) {
        if (isWholeNumber(number)) shown.materials.insert(number.get<std::size_t>());
      });
    }
  }
  return shown;
}

class StaleChannels {
 public:
  StaleChannels(const Json& before, const Json& tree)
      : tree_(tree), was_(shownBy(before)), is_(shownBy(tree)) {}

  // The name under which a stale channel is reported as lost; null if it is not stale.
  const char* reasonFor(Json& channel) const {
    if (const Json* const pointer = pointerOf(channel)) {
      const std::optional<Pointed> to = parsePointer(*pointer);
      return to && isGone(*to) ? kPointer : nullptr;
    }
    if (!channel.is_object() || !channel.contains("target")) return nullptr;
    const Json& target = channel["target"];
    if (!target.is_object() || target.value("path", Json()) != "weights") return nullptr;
    const Json node = target.value("node", Json());
    return isWholeNumber(node) && hasLostTargets(node.get<std::size_t>()) ? kWeights : nullptr;
  }

 private:
  bool isGone(const Pointed& to) const {
    if (to.list == "materials")
      return was_.materials.count(to.number) > is_.materials.count(to.number);
    if (!to.rest.starts_with("/weights")) return false;
    if (to.list == "meshes") return was_.morphed.count(to.number) > is_.morphed.count(to.number);
    return to.list == "nodes" && hasLostTargets(to.number);
  }

  bool hasLostTargets(std::size_t node) const {
    if (!tree_.contains("nodes") || node >= tree_["nodes"].size()) return false;
    const Json mesh = tree_["nodes"][node].value("mesh", Json());
    if (!isWholeNumber(mesh)) return false;
    const auto number = mesh.get<std::size_t>();
    return was_.morphed.count(number) > is_.morphed.count(number);
  }

  const Json& tree_;
  Shown was_, is_;
};

// Drops samplers that no channel uses.
void dropUnusedSamplers(Json& animation, LostExtensions& lost) {
  std::set<std::size_t> used;
  for (const Json& channel : animation["channels"])
    if (isWholeNumber(channel["sampler"])) used.insert(channel["sampler"].get<std::size_t>());
  Json kept = Json::array();
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < animation["samplers"].size(); ++i) {
    numbers.push_back(kept.size());
    const Json& sampler = animation["samplers"][i];
    if (used.count(i) == 1) {
      kept.push_back(sampler);
      continue;
    }
    for (const char* member : {"input", "output"})
      if (sampler.is_object() && sampler.contains(member) && isWholeNumber(sampler[member]))
        lost.accessors.insert(sampler[member].get<int>());
  }
  animation["samplers"] = std::move(kept);
  for (Json& channel : animation["channels"]) {
    Json& number = channel["sampler"];
    if (isWholeNumber(number) && number.get<std::size_t>() < numbers.size())
      number = numbers[number.get<std::size_t>()];
  }
}

}  // namespace

void forEachMaterialPointer(Json& tree, const std::function<void(Json& number)>& visit) {
  forEachChannel(tree, [&](Json& channel) {
    Json* const pointer = pointerOf(channel);
    const std::optional<Pointed> to = pointer ? parsePointer(*pointer) : std::nullopt;
    if (!to || to->list != "materials") return;
    Json number = to->number;
    visit(number);
    *pointer = "/materials/" + number.dump() + to->rest;
  });
}

void settlePointers(const Json& before, Json& tree, LostExtensions& lost) {
  if (!tree.contains("animations") || !tree["animations"].is_array()) return;
  const StaleChannels stale(before, tree);
  Json animations = Json::array();
  for (Json& animation : tree["animations"]) {
    Json channels = Json::array();
    for (Json& channel : animation["channels"]) {
      const char* const reason = stale.reasonFor(channel);
      if (reason)
        ++lost.count[reason];
      else
        channels.push_back(std::move(channel));
    }
    const bool isWhole = channels.size() == animation["channels"].size();
    animation["channels"] = std::move(channels);
    if (!isWhole) dropUnusedSamplers(animation, lost);
    if (isWhole || !animation["channels"].empty()) animations.push_back(std::move(animation));
  }
  if (animations.empty())
    tree.erase("animations");
  else
    tree["animations"] = std::move(animations);
}

}  // namespace remesher::io
