// SPDX-License-Identifier: MIT
#include "io/gltf/gltf_union.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "io/files.h"
#include "io/gltf/gltf_maker.h"

using namespace remesher;
using namespace remesher::test;

namespace {

// Two skinned squares, by these skins; the joint lies away from the origin.
io::Model united(int firstSkin, int secondSkin) {
  GltfMaker maker;
  for (int square = 0; square < 2; ++square) {
    const std::vector<std::uint8_t> joints(16, 0);
    const std::vector<float> weights = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
    const int positions = maker.add(kSquarePositions, kFloat, "VEC3");
    maker.tree["accessors"][positions]["min"] = {0, 0, 0};
    maker.tree["accessors"][positions]["max"] = {1, 1, 0};
    maker.addMesh({{{"attributes",
                     {{"POSITION", positions},
                      {"JOINTS_0", maker.add(joints, kUByte, "VEC4")},
                      {"WEIGHTS_0", maker.add(weights, kFloat, "VEC4")}}},
                    {"indices", maker.add(kSquareIndices, kUShort, "SCALAR")}}});
  }
  maker.show({{{"mesh", 0}, {"skin", firstSkin}},
              {{"mesh", 1}, {"skin", secondSkin}},
              {{"translation", {5, 0, 0}}}});
  maker.tree["skins"] = Json::array({Json{{"joints", {2}}}, Json{{"joints", {2}}}});
  io::Model model = io::read(maker.glb());
  io::uniteGltf(model);
  return model;
}

bool isSkinned(const io::Model& model) {
  const auto& attributes = model.parts.front().mesh.attributes;
  return std::any_of(attributes.begin(), attributes.end(),
                     [](const Attribute& a) { return a.semantic == "JOINTS_0"; });
}

}  // namespace

TEST_CASE("gltf_union: one skin of all meshes stays, in their own space") {
  const io::Model model = united(0, 0);
  REQUIRE(model.parts.size() == 1);
  CHECK(isSkinned(model));
  CHECK(model.warnings.empty());
  double largest = 0;
  for (const Vec3& p : model.parts.front().mesh.positions) largest = std::max(largest, p.x());
  CHECK(largest == 1);
  const Json tree = treeOf(io::write(model, "out.glb").files[0]);
  const auto& nodes = tree["nodes"];
  CHECK(std::count_if(nodes.begin(), nodes.end(), [](const Json& node) {
          return node.contains("mesh") && node.value("skin", -1) == 0;
        }) == 1);
}

TEST_CASE("gltf_union: meshes of several skins do not move once they are one") {
  const io::Model model = united(0, 1);
  REQUIRE(model.parts.size() == 1);
  CHECK_FALSE(isSkinned(model));
  CHECK(model.warnings.size() == 1);
}
