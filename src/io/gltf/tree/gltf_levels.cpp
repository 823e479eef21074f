// SPDX-License-Identifier: MIT
#include "io/gltf/tree/gltf_levels.h"

#include <algorithm>
#include <cctype>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/gltf/tree/gltf_extensions.h"

namespace remesher::io {
namespace {

using Visitor = std::function<void(Json& number)>;

const Json* nodeAt(const Json& tree, std::size_t number) {
  if (!tree.contains("nodes") || !tree["nodes"].is_array()) return nullptr;
  return number < tree["nodes"].size() ? &tree["nodes"][number] : nullptr;
}

// The numbers in a list of the node: its children, or its levels.
std::vector<std::size_t> numbersIn(const Json& node, const Json::json_pointer& path) {
  std::vector<std::size_t> numbers;
  if (!node.is_object() || !node.contains(path) || !node[path].is_array()) return numbers;
  for (const Json& number : node[path])
    if (isWholeNumber(number)) numbers.push_back(number.get<std::size_t>());
  return numbers;
}

std::vector<std::size_t> levelsOf(const Json& node) {
  return numbersIn(node, Json::json_pointer("/extensions/MSFT_lod/ids"));
}

// Nodes with all their descendants; a broken file may have cycles.
class Families {
 public:
  explicit Families(const Json& tree) : tree_(tree) {}

  // Visits no node twice: a chain of n nodes, each added, takes n steps.
  void add(std::size_t root) {
    std::vector<std::size_t> open = {root};
    while (!open.empty()) {
      const std::size_t number = open.back();
      open.pop_back();
      const Json* const node = nodeAt(tree_, number);
      if (node == nullptr || !nodes_.insert(number).second) continue;
      for (const std::size_t child : numbersIn(*node, Json::json_pointer("/children")))
        open.push_back(child);
    }
  }

  const std::set<std::size_t>& nodes() const { return nodes_; }

 private:
  const Json& tree_;
  std::set<std::size_t> nodes_;
};

std::set<int> meshesOf(const Json& tree, std::size_t root) {
  std::set<int> meshes;
  Families family(tree);
  family.add(root);
  for (const std::size_t number : family.nodes()) {
    const Json mesh =
        nodeAt(tree, number)->is_object() ? nodeAt(tree, number)->value("mesh", Json()) : Json();
    if (isWholeNumber(mesh)) meshes.insert(mesh.get<int>());
  }
  return meshes;
}

void visitList(Json& holder, const char* key, const Visitor& visit) {
  if (!holder.is_object() || !holder.contains(key) || !holder[key].is_array()) return;
  for (Json& number : holder[key]) visit(number);
}

void visitMembers(Json& tree, const char* list, const std::function<void(Json& member)>& visit) {
  if (!tree.contains(list) || !tree[list].is_array()) return;
  for (Json& member : tree[list])
    if (member.is_object()) visit(member);
}

// A level by its name: `rock_LOD1` is level 1 of `rock_`.
struct NamedLevel {
  std::string stem;
  std::size_t level;
};

std::optional<NamedLevel> namedLevel(const Json& node) {
  const Json name = node.is_object() ? node.value("name", Json()) : Json();
  if (!name.is_string()) return std::nullopt;
  std::string stem = name.get<std::string>();
  std::string digits;
  const auto last = [&] { return stem.empty() ? '\0' : stem.back(); };
  for (; last() >= '0' && last() <= '9'; stem.pop_back()) digits.insert(0, 1, last());
  constexpr std::size_t kMostDigits = 2;
  if (digits.empty() || digits.size() > kMostDigits) return std::nullopt;
  if (last() == '_' || last() == '-' || last() == ' ') stem.pop_back();
  for (const char letter : {'d', 'o', 'l'}) {
    if (std::tolower(static_cast<unsigned char>(last())) != letter) return std::nullopt;
    stem.pop_back();
  }
  // `melod1` is no level.
  if (std::isalpha(static_cast<unsigned char>(last()))) return std::nullopt;
  return NamedLevel{stem, std::stoul(digits)};
}

// The levels of one object among siblings, each a list of nodes; the finest first.
using NamedFamily = std::map<std::size_t, std::vector<std::size_t>>;

std::vector<NamedFamily> familiesAmong(const Json& tree, const std::vector<std::size_t>& siblings) {
  std::map<std::string, NamedFamily> byStem;
  for (const std::size_t number : siblings)
    if (const Json* const node = nodeAt(tree, number))
      if (const auto named = namedLevel(*node)) byStem[named->stem][named->level].push_back(number);
  std::vector<NamedFamily> families;
  for (auto& [stem, levels] : byStem)
    if (levels.size() > 1) families.push_back(std::move(levels));
  return families;
}

// The families among the children of each node and among the nodes of each scene.
std::vector<NamedFamily> namedFamilies(const Json& tree) {
  std::vector<NamedFamily> all;
  const auto add = [&](const char* list, const char* key) {
    if (!tree.contains(list) || !tree[list].is_array()) return;
    for (const Json& holder : tree[list])
      for (NamedFamily& levels :
           familiesAmong(tree, numbersIn(holder, Json::json_pointer(std::string("/") + key))))
        all.push_back(std::move(levels));
  };
  add("nodes", "children");
  add("scenes", "nodes");
  return all;
}

// The places outside of nodes where the tree names nodes: scenes, skins, animations.
void forEachOuterNode(Json& tree, const Visitor& visit) {
  visitMembers(tree, "scenes", [&](Json& scene) { visitList(scene, "nodes", visit); });
  visitMembers(tree, "skins", [&](Json& skin) {
    visitList(skin, "joints", visit);
    if (skin.contains("skeleton")) visit(skin["skeleton"]);
  });
  visitMembers(tree, "animations", [&](Json& animation) {
    visitMembers(animation, "channels", [&](Json& channel) {
      if (channel.contains("target") && channel["target"].contains("node"))
        visit(channel["target"]["node"]);
    });
  });
}

void forEachInnerNode(Json& tree, const Visitor& visit) {
  visitMembers(tree, "nodes", [&](Json& node) {
    visitList(node, "children", visit);
    const Json::json_pointer levels("/extensions/MSFT_lod/ids");
    if (node.contains(levels))
      for (Json& number : node[levels]) visit(number);
  });
}

void forEachMesh(Json& tree, const Visitor& visit) {
  visitMembers(tree, "nodes", [&](Json& node) {
    if (node.contains("mesh")) visit(node["mesh"]);
  });
}

// Removes elements from a list; returns the new numbers of the others.
std::vector<std::size_t> takeOut(Json& tree, const char* list, const std::set<std::size_t>& gone) {
  std::vector<std::size_t> numbers;
  Json kept = Json::array();
  for (std::size_t i = 0; i < tree[list].size(); ++i) {
    numbers.push_back(kept.size());
    if (gone.count(i) == 0) kept.push_back(std::move(tree[list][i]));
  }
  tree[list] = std::move(kept);
  return numbers;
}

Visitor renumbering(const std::vector<std::size_t>& numbers) {
  return [&numbers](Json& number) {
    if (isWholeNumber(number) && number.get<std::size_t>() < numbers.size())
      number = numbers[number.get<std::size_t>()];
  };
}

// Whether anything may name nodes or meshes that is not visited here, pointers included.
bool mayNameNodes(const Json& value) {
  if (value.is_string()) {
    const auto& text = value.get_ref<const std::string&>();
    return text.starts_with("/nodes/") || text.starts_with("/meshes/");
  }
  if (!value.is_structured()) return false;
  if (value.is_object() && value.contains("extensions") && value["extensions"].is_object())
    for (const auto& [name, extension] : value["extensions"].items())
      if (hiddenIn(name) != Hidden::Nothing || name.starts_with("KHR_physics")) return true;
  for (const Json& member : value)
    if (mayNameNodes(member)) return true;
  return false;
}

// Collects the accessors that a mesh names.
void collectAccessors(const Json& mesh, std::set<int>& accessors) {
  const auto insert = [&](const Json& number) {
    if (isWholeNumber(number)) accessors.insert(number.get<int>());
  };
  for (const Json& primitive : mesh.value("primitives", Json::array())) {
    insert(primitive.value("indices", Json()));
    for (const Json& number : primitive.value("attributes", Json::object())) insert(number);
    for (const Json& target : primitive.value("targets", Json::array()))
      for (const Json& number : target) insert(number);
  }
}

// Takes out meshes that no node names; returns their accessors.
std::set<int> takeOutMeshes(Json& tree, const std::set<std::size_t>& meshes) {
  std::set<int> accessors;
  for (const std::size_t mesh : meshes) collectAccessors(tree["meshes"][mesh], accessors);
  const std::vector<std::size_t> numbers = takeOut(tree, "meshes", meshes);
  forEachMesh(tree, renumbering(numbers));
  return accessors;
}

// Drops the channels that move dropped nodes, and animations without any other channel.
void stopAnimations(Json& tree, const std::set<std::size_t>& gone) {
  if (!tree.contains("animations")) return;
  Json animations = Json::array();
  for (Json& animation : tree["animations"]) {
    Json channels = Json::array();
    for (Json& channel : animation["channels"]) {
      const Json node = channel["target"].value("node", Json());
      if (!isWholeNumber(node) || gone.count(node.get<std::size_t>()) == 0)
        channels.push_back(std::move(channel));
    }
    animation["channels"] = std::move(channels);
    if (!animation["channels"].empty()) animations.push_back(std::move(animation));
  }
  if (animations.empty())
    tree.erase("animations");
  else
    tree["animations"] = std::move(animations);
}

}  // namespace

std::map<int, std::set<int>> meshLevels(const Json& tree) {
  std::map<int, std::set<int>> levels;
  std::set<int> finest;
  const std::size_t count = tree.contains("nodes") ? tree["nodes"].size() : 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::vector<std::size_t> ids = levelsOf(tree["nodes"][i]);
    if (ids.empty()) continue;
    const std::set<int> own = meshesOf(tree, i);
    finest.insert(own.begin(), own.end());
    for (const std::size_t id : ids)
      for (const int mesh : meshesOf(tree, id)) levels[mesh].insert(own.begin(), own.end());
  }
  for (const int mesh : finest) levels.erase(mesh);
  return levels;
}

std::map<int, std::set<int>> meshLevelsByName(const Json& tree) {
  std::map<int, std::set<int>> levels;
  std::set<int> finest;
  for (const NamedFamily& named : namedFamilies(tree)) {
    std::set<int> own;
    for (const std::size_t node : named.begin()->second) own.merge(meshesOf(tree, node));
    for (auto level = std::next(named.begin()); level != named.end(); ++level)
      for (const std::size_t node : level->second)
        for (const int mesh : meshesOf(tree, node)) levels[mesh].insert(own.begin(), own.end());
    finest.merge(own);
  }
  for (const int mesh : finest) levels.erase(mesh);
  return levels;
}

std::set<std::size_t> takeLevels(Json& tree) {
  std::set<std::size_t> named;
  for (const NamedFamily& levels : namedFamilies(tree))
    for (auto level = std::next(levels.begin()); level != levels.end(); ++level)
      named.insert(level->second.begin(), level->second.end());
  const auto unhang = [&](const char* list, const char* key) {
    visitMembers(tree, list, [&](Json& holder) {
      if (!holder.contains(key) || !holder[key].is_array()) return;
      Json kept = Json::array();
      for (const Json& number : holder[key])
        if (!isWholeNumber(number) || named.count(number.get<std::size_t>()) == 0)
          kept.push_back(number);
      holder[key] = std::move(kept);
    });
  };
  unhang("nodes", "children");
  unhang("scenes", "nodes");
  Families taken(tree);
  for (const std::size_t node : named) taken.add(node);
  visitMembers(tree, "nodes", [&](Json& node) {
    for (const std::size_t level : levelsOf(node)) taken.add(level);
    if (!node.contains("extensions") || !node["extensions"].is_object()) return;
    if (node["extensions"].erase(kLevelsExtension) == 0) return;
    if (node.contains("extras") && node["extras"].is_object())
      node["extras"].erase("MSFT_screencoverage");  // a number for each level
    if (node["extensions"].empty()) node.erase("extensions");
  });
  return taken.nodes();
}

std::set<int> dropNodes(Json& tree, const std::set<std::size_t>& nodes) {
  if (nodes.empty()) return {};
  Families kept(tree);
  const auto keep = [&](const Json& number) {
    if (isWholeNumber(number)) kept.add(number.get<std::size_t>());
  };
  visitMembers(tree, "scenes", [&](Json& scene) { visitList(scene, "nodes", keep); });
  visitMembers(tree, "skins", [&](Json& skin) { visitList(skin, "joints", keep); });
  for (std::size_t i = 0; tree.contains("nodes") && i < tree["nodes"].size(); ++i)
    if (nodes.count(i) == 0) {
      kept.add(i);
      for (const std::size_t level : levelsOf(tree["nodes"][i])) kept.add(level);
    }
  std::set<std::size_t> gone = nodes;
  for (const std::size_t node : kept.nodes()) gone.erase(node);
  if (gone.empty() || mayNameNodes(tree)) return {};
  stopAnimations(tree, gone);
  std::set<std::size_t> meshes;
  for (const std::size_t number : gone)
    if (isWholeNumber(tree["nodes"][number].value("mesh", Json())))
      meshes.insert(tree["nodes"][number]["mesh"].get<std::size_t>());
  const std::vector<std::size_t> numbers = takeOut(tree, "nodes", gone);
  forEachOuterNode(tree, renumbering(numbers));
  forEachInnerNode(tree, renumbering(numbers));
  forEachMesh(tree, [&](Json& number) {
    if (isWholeNumber(number)) meshes.erase(number.get<std::size_t>());
  });
  return takeOutMeshes(tree, meshes);
}

std::set<int> dropMeshes(Json& tree, const std::set<std::size_t>& meshes) {
  if (meshes.empty()) return {};
  visitMembers(tree, "nodes", [&](Json& node) {
    const Json mesh = node.value("mesh", Json());
    if (!isWholeNumber(mesh) || meshes.count(mesh.get<std::size_t>()) == 0) return;
    for (const char* key : {"mesh", "skin", "weights"}) node.erase(key);
    if (!node.contains("extensions")) return;
    node["extensions"].erase("EXT_mesh_gpu_instancing");
    if (node["extensions"].empty()) node.erase("extensions");
  });
  return mayNameNodes(tree) ? std::set<int>() : takeOutMeshes(tree, meshes);
}

}  // namespace remesher::io
