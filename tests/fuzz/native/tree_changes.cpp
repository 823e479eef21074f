// SPDX-License-Identifier: MIT
#include "tree_changes.h"

#include <array>
#include <functional>
#include <vector>

#include "byte_changes.h"

namespace remesher::fuzz {
namespace {

// Every value below `tree` for which `isWanted` holds.
std::vector<Json*> valuesIn(Json& tree, const std::function<bool(const Json&)>& isWanted) {
  std::vector<Json*> found;
  if (!tree.is_structured()) return found;
  for (Json& value : tree) {
    if (isWanted(value)) found.push_back(&value);
    const std::vector<Json*> below = valuesIn(value, isWanted);
    found.insert(found.end(), below.begin(), below.end());
  }
  return found;
}

// One of the list `name`; null if there is none.
Json* oneOf(Json& tree, const char* name, soups::Random& random) {
  const auto list = tree.find(name);
  if (list == tree.end() || !list->is_array() || list->empty()) return nullptr;
  Json& one = (*list)[pick(random, list->size())];
  return one.is_object() ? &one : nullptr;
}

std::size_t lengthOf(const Json& tree, const char* name) {
  const auto list = tree.find(name);
  return list == tree.end() || !list->is_array() ? 0 : list->size();
}

// A number of the list, or the first beyond it.
Json indexInto(const Json& tree, const char* name, soups::Random& random) {
  return pick(random, lengthOf(tree, name) + 1);
}

Json wholeNumber(soups::Random& random) {
  constexpr std::array<std::int64_t, 15> kNumbers = {
      0, 1, 2, 3, 4, 7, 16, -1, 255, 256, 65535, 65536, 2147483647, 4294967295, 9007199254740992};
  return kNumbers[pick(random, kNumbers.size())];
}

Json componentType(soups::Random& random) {
  constexpr std::array<int, 7> kTypes = {5120, 5121, 5122, 5123, 5125, 5126, 5130};
  return kTypes[pick(random, kTypes.size())];
}

void changeNumber(Json& tree, soups::Random& random) {
  const std::vector<Json*> all =
      valuesIn(tree, [](const Json& value) { return value.is_number(); });
  if (all.empty()) return;
  Json& value = *all[pick(random, all.size())];
  switch (pick(random, 3)) {
    case 0:
      value = value.get<double>() + (random.number() < 0.5 ? 1 : -1);
      break;
    case 1:
      value = wholeNumber(random);
      break;
    default:
      value = wildNumber(random);
  }
}

void changeType(Json& tree, soups::Random& random) {
  const std::vector<Json*> all = valuesIn(tree, [](const Json&) { return true; });
  if (all.empty()) return;
  const std::array<Json, 6> others = {nullptr, "text", Json::array(), Json::object(), true, 5};
  *all[pick(random, all.size())] = others[pick(random, others.size())];
}

void loseMember(Json& tree, soups::Random& random) {
  std::vector<Json*> all =
      valuesIn(tree, [](const Json& value) { return value.is_structured() && !value.empty(); });
  all.push_back(&tree);
  Json& holder = *all[pick(random, all.size())];
  if (holder.empty()) return;
  const auto place = static_cast<Json::difference_type>(pick(random, holder.size()));
  holder.erase(holder.begin() + place);
}

void repeatMember(Json& tree, soups::Random& random) {
  const std::vector<Json*> all =
      valuesIn(tree, [](const Json& value) { return value.is_array() && !value.empty(); });
  if (all.empty()) return;
  Json& list = *all[pick(random, all.size())];
  const Json copy = list[pick(random, list.size())];
  list.push_back(copy);
}

void changeAccessor(Json& tree, soups::Random& random) {
  constexpr std::array kTypes = {"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4", "VEC5"};
  Json* const accessor = oneOf(tree, "accessors", random);
  if (accessor == nullptr) return;
  switch (pick(random, 4)) {
    case 0:
      (*accessor)["componentType"] = componentType(random);
      break;
    case 1:
      (*accessor)["type"] = kTypes[pick(random, kTypes.size())];
      break;
    case 2:
      (*accessor)["count"] = wholeNumber(random);
      break;
    default:
      (*accessor)["bufferView"] = indexInto(tree, "bufferViews", random);
  }
}

void changeView(Json& tree, soups::Random& random) {
  constexpr std::array kFields = {"byteOffset", "byteLength", "byteStride", "buffer"};
  if (Json* const view = oneOf(tree, "bufferViews", random))
    (*view)[kFields[pick(random, kFields.size())]] = wholeNumber(random);
}

void addSparse(Json& tree, soups::Random& random) {
  Json* const accessor = oneOf(tree, "accessors", random);
  if (accessor == nullptr) return;
  Json& sparse = (*accessor)["sparse"];
  sparse = {{"count", wholeNumber(random)}};
  sparse["indices"] = {{"bufferView", indexInto(tree, "bufferViews", random)},
                       {"componentType", componentType(random)}};
  sparse["values"] = {{"bufferView", indexInto(tree, "bufferViews", random)}};
}

// As KHR_mesh_quantization allows it, and beyond.
void quantise(Json& tree, soups::Random& random) {
  Json* const accessor = oneOf(tree, "accessors", random);
  if (accessor == nullptr) return;
  (*accessor)["componentType"] = componentType(random);
  (*accessor)["normalized"] = random.number() < 0.7;
  tree["extensionsUsed"] = tree["extensionsRequired"] = Json::array({"KHR_mesh_quantization"});
}

// Null if there is none.
Json* onePrimitive(Json& tree, soups::Random& random) {
  Json* const mesh = oneOf(tree, "meshes", random);
  return mesh == nullptr ? nullptr : oneOf(*mesh, "primitives", random);
}

void changePrimitive(Json& tree, soups::Random& random) {
  constexpr std::array kNames = {"POSITION", "NORMAL",   "TANGENT",   "TEXCOORD_0", "COLOR_0",
                                 "JOINTS_0", "JOINTS_1", "WEIGHTS_0", "WEIGHTS_1",  "_EXTRA"};
  Json* const primitive = onePrimitive(tree, random);
  if (primitive == nullptr) return;
  const Json accessor = indexInto(tree, "accessors", random);
  const char* const name = kNames[pick(random, kNames.size())];
  switch (pick(random, 5)) {
    case 0:
      (*primitive)["mode"] = pick(random, 8);
      break;
    case 1:
      (*primitive)["indices"] = accessor;
      break;
    case 2:
      (*primitive)["targets"] = Json::array({Json{{name, accessor}}});
      break;
    default:
      if ((*primitive)["attributes"].is_object()) (*primitive)["attributes"][name] = accessor;
  }
}

void addSkin(Json& tree, soups::Random& random) {
  tree["skins"] = Json::array();
  tree["skins"].push_back({{"joints", Json::array({indexInto(tree, "nodes", random)})},
                           {"inverseBindMatrices", indexInto(tree, "accessors", random)}});
  // Only now: a new member moves all that are in the tree.
  if (Json* const node = oneOf(tree, "nodes", random)) (*node)["skin"] = 0;
}

void changeNode(Json& tree, soups::Random& random) {
  Json* const node = oneOf(tree, "nodes", random);
  if (node == nullptr) return;
  const auto numbers = [&](std::size_t count) {
    Json list = Json::array();
    while (list.size() < count) list.push_back(wildNumber(random));
    return list;
  };
  constexpr std::array kFields = {"translation", "rotation", "scale", "matrix"};
  constexpr std::array<std::size_t, 4> kLengths = {3, 4, 3, 16};
  const std::size_t field = pick(random, kFields.size());
  if (random.number() < 0.3)
    (*node)["children"] = Json::array({indexInto(tree, "nodes", random)});
  else
    (*node)[kFields[field]] = numbers(kLengths[field]);
}

// Compressed ranges reach the core only where what unpacks them was left out.
void pretendCompression(Json& tree, soups::Random& random) {
  const Json view = indexInto(tree, "bufferViews", random);
  if (random.number() < 0.5) {
    if (Json* const primitive = onePrimitive(tree, random))
      (*primitive)["extensions"]["KHR_draco_mesh_compression"] = {
          {"bufferView", view}, {"attributes", {{"POSITION", wholeNumber(random)}}}};
  } else if (Json* const one = oneOf(tree, "bufferViews", random)) {
    (*one)["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0},
                                                       {"byteLength", wholeNumber(random)},
                                                       {"byteStride", wholeNumber(random)},
                                                       {"mode", "ATTRIBUTES"},
                                                       {"count", wholeNumber(random)}};
  }
}

}  // namespace

void changeTree(Json& tree, soups::Random& random) {
  constexpr std::array kChanges = {changeNumber,      changeNumber,    changeType, loseMember,
                                   repeatMember,      changeAccessor,  changeView, addSparse,
                                   quantise,          changePrimitive, addSkin,    changeNode,
                                   pretendCompression};
  try {
    kChanges[pick(random, kChanges.size())](tree, random);
  } catch (const Json::exception&) {  // what an earlier change has made of another type
  }
}

}  // namespace remesher::fuzz
