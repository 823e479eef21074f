// SPDX-License-Identifier: MIT
#include "io/gltf/tree/gltf_pointers.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace remesher;
using io::Json;

namespace {

Json channelTo(const std::string& pointer, int sampler) {
  return {
      {"sampler", sampler},
      {"target",
       {{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", pointer}}}}}}}};
}

Json samplers(int count) {
  Json list = Json::array();
  for (int i = 0; i < count; ++i) list.push_back({{"input", 10}, {"output", 11 + i}});
  return list;
}

Json treeWith(const std::vector<int>& materials, const Json& animations) {
  Json primitives = Json::array();
  for (const int number : materials)
    primitives.push_back({{"attributes", {{"POSITION", 0}}}, {"material", number}});
  return {{"meshes", {{{"primitives", primitives}}}}, {"animations", animations}};
}

}  // namespace

TEST_CASE("pointers: what animates a material that nothing shows any more goes") {
  const Json animations = {
      {{"channels",
        {channelTo("/materials/2/emissiveFactor", 0), channelTo("/materials/1/emissiveFactor", 1),
         channelTo("/nodes/0/translation", 1)}},
       {"samplers", samplers(2)}},
      {{"channels", {channelTo("/materials/2/alphaCutoff", 0)}}, {"samplers", samplers(1)}}};
  const Json before = treeWith({1, 2}, animations);
  Json tree = treeWith({1, 3}, animations);
  io::LostExtensions lost;
  io::settlePointers(before, tree, lost);
  REQUIRE(tree["animations"].size() == 1);
  const Json& animation = tree["animations"][0];
  CHECK(animation["channels"] ==
        Json{channelTo("/materials/1/emissiveFactor", 0), channelTo("/nodes/0/translation", 0)});
  CHECK(animation["samplers"] == Json{{{"input", 10}, {"output", 12}}});
  CHECK(lost.count["KHR_animation_pointer"] == 2);
  CHECK(lost.accessors == std::set<int>{10, 11});
}

TEST_CASE("pointers: materials that get other numbers are followed") {
  Json tree = treeWith({3}, {{{"channels",
                               {channelTo("/materials/3/pbrMetallicRoughness/roughnessFactor", 0),
                                channelTo("/materials/x/y", 0), channelTo("/nodes/3/scale", 0)}},
                              {"samplers", samplers(1)}}});
  io::forEachMaterialPointer(tree, [](Json& number) {
    CHECK(number == 3);
    number = 0;
  });
  const Json& channels = tree["animations"][0]["channels"];
  CHECK(channels[0] == channelTo("/materials/0/pbrMetallicRoughness/roughnessFactor", 0));
  CHECK(channels[1] == channelTo("/materials/x/y", 0));
  CHECK(channels[2] == channelTo("/nodes/3/scale", 0));
}

TEST_CASE("pointers: weights of morph targets that are gone are not animated") {
  const Json weights = {{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}};
  Json before = treeWith(
      {0}, {{{"channels",
              {weights, channelTo("/meshes/0/weights/0", 0), channelTo("/nodes/0/weights", 0)}},
             {"samplers", samplers(1)}}});
  before["nodes"] = {{{"mesh", 0}}};
  Json tree = before;
  before["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", 1}}};
  io::LostExtensions lost;
  Json kept = before;
  io::settlePointers(before, kept, lost);
  CHECK(kept == before);
  CHECK(lost.count.empty());
  io::settlePointers(before, tree, lost);
  CHECK(!tree.contains("animations"));
  CHECK(lost.count.size() == 2);
}
