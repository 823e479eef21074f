// SPDX-License-Identifier: MIT
#include "io/gltf/tree/gltf_levels.h"

#include <doctest/doctest.h>

using namespace remesher;
using io::Json;

namespace {

Json levelsOf(const Json& ids) { return {{"MSFT_lod", {{"ids", ids}}}}; }

Json meshes(int count) {
  Json list = Json::array();
  for (int i = 0; i < count; ++i)
    list.push_back({{"primitives", {{{"attributes", {{"POSITION", i}}}}}}});
  return list;
}

// A finest level of two meshes below a node, a level of two and one of one; and a node beside them.
Json family() {
  return {{"scenes", {{{"nodes", {0, 6}}}}},
          {"nodes",
           {{{"children", {1}}, {"mesh", 0}, {"extensions", levelsOf({2, 4})}},
            {{"mesh", 1}},
            {{"children", {3}}, {"mesh", 2}},
            {{"mesh", 3}},
            {{"mesh", 4}, {"skin", 0}},
            {{"name", "unused"}},
            {{"mesh", 5}, {"name", "other"}}}},
          {"meshes", meshes(6)}};
}

}  // namespace

TEST_CASE("levels: those of a node are levels of all that hangs below it") {
  const std::map<int, std::set<int>> expected = {{2, {0, 1}}, {3, {0, 1}}, {4, {0, 1}}};
  CHECK(io::meshLevels(family()) == expected);
  CHECK(io::meshLevels(Json::object()).empty());
  // What is a finest level somewhere is none of another; circles end.
  Json circle = {{"nodes",
                  {{{"mesh", 0}, {"extensions", levelsOf({1})}},
                   {{"mesh", 1}, {"children", {1}}, {"extensions", levelsOf({0, 99, -1})}}}}};
  CHECK(io::meshLevels(circle).empty());
}

TEST_CASE("levels: what goes leaves no number behind that means another") {
  Json tree = family();
  tree["animations"] = {
      {{"channels", {{{"sampler", 0}, {"target", {{"node", 2}, {"path", "scale"}}}}}}},
      {{"channels", {{{"sampler", 0}, {"target", {{"node", 6}, {"path", "scale"}}}}}}}};
  tree["nodes"][0]["extras"] = {{"MSFT_screencoverage", {0.5, 0.2, 0.1}}};
  const std::set<std::size_t> taken = io::takeLevels(tree);
  CHECK(taken == std::set<std::size_t>{2, 3, 4});
  CHECK(io::dropNodes(tree, taken) == std::set<int>{2, 3, 4});
  CHECK(tree["meshes"].size() == 3);
  REQUIRE(tree["nodes"].size() == 4);
  CHECK(tree["scenes"][0]["nodes"] == Json{0, 3});
  CHECK(!tree["nodes"][0].contains("extensions"));
  CHECK(tree["nodes"][0]["extras"].empty());
  CHECK(tree["nodes"][3]["name"] == "other");
  CHECK(tree["meshes"][tree["nodes"][3]["mesh"].get<int>()]["primitives"][0]["attributes"]
            ["POSITION"] == 5);
  REQUIRE(tree["animations"].size() == 1);
  CHECK(tree["animations"][0]["channels"][0]["target"]["node"] == 3);
}

TEST_CASE("levels: a node that something else shows stays, and all where one may be named unseen") {
  Json shared = family();
  shared["scenes"][0]["nodes"].push_back(2);
  const std::set<std::size_t> taken = io::takeLevels(shared);
  io::dropNodes(shared, taken);
  CHECK(shared["nodes"].size() == 6);
  CHECK(shared["meshes"].size() == 5);
  Json unknown = family();
  unknown["extensions"]["ACME_graph"] = {{"node", 4}};
  io::dropNodes(unknown, io::takeLevels(unknown));
  CHECK(unknown["nodes"].size() == 7);
}

TEST_CASE("levels: nodes side by side that are named so are levels") {
  const auto named = [](const char* name, int mesh) {
    return Json{{"name", name}, {"mesh", mesh}};
  };
  Json tree = {{"scenes", {{{"nodes", {0, 1, 2, 6}}}}},
               {"nodes",
                {named("rock_LOD0", 0),
                 named("rock_LOD1", 1),
                 named("rock_LOD2", 2),
                 named("lod1", 3),
                 named("melod0", 4),
                 named("rock.lod 1", 5),
                 {{"name", "tree"}, {"children", {3, 7, 4, 5}}},
                 named("lod0", 6)}},
               {"meshes", meshes(7)}};
  const std::map<int, std::set<int>> expected = {{1, {0}}, {2, {0}}, {3, {6}}};
  CHECK(io::meshLevelsByName(tree) == expected);
  const std::set<std::size_t> taken = io::takeLevels(tree);
  CHECK(taken == std::set<std::size_t>{1, 2, 3});
  CHECK(tree["scenes"][0]["nodes"] == Json{0, 6});
  CHECK(io::dropNodes(tree, taken) == std::set<int>{1, 2, 3});
  CHECK(tree["nodes"].size() == 5);
  CHECK(tree["meshes"].size() == 4);
  CHECK(io::meshLevelsByName(tree).empty());
}
