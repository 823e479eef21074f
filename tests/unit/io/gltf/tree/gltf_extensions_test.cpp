// SPDX-License-Identifier: MIT
#include "io/gltf/tree/gltf_extensions.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "io/files.h"
#include "io/gltf/gltf_maker.h"

using namespace remesher;
using namespace remesher::test;

namespace {

// A square with two sets of coordinates and identifiers.
GltfMaker identifiedSquare() {
  GltfMaker maker;
  const int texcoords = maker.add(std::vector<float>{0, 0, 1, 0, 1, 1, 0, 1}, kFloat, "VEC2");
  maker.addMesh(
      {{{"attributes",
         {{"POSITION", maker.add(kSquarePositions, kFloat, "VEC3")},
          {"TEXCOORD_0", texcoords},
          {"_FEATURE_ID_0", maker.add(std::vector<float>{7, 7, 7, 7}, kFloat, "SCALAR")}}},
        {"indices", maker.add(kSquareIndices, kUShort, "SCALAR")}}});
  maker.show({{{"mesh", 0}}});
  return maker;
}

io::WrittenFiles written(const File& file) {
  io::Model model = io::read(file);
  std::reverse(model.parts[0].mesh.indices.begin(), model.parts[0].mesh.indices.end());
  model.parts[0].mesh.isQuads = false;
  return io::write(model, "out.glb");
}

std::size_t saidLost(const io::WrittenFiles& files) {
  for (const Warning& warning : files.warnings)
    if (warning.code == "EXTENSION_NOT_CARRIED") return warning.count;
  return 0;
}

// The extensions of the first primitive once its triangles are made anew.
Json afterwards(const std::string& name, const Json& extension, std::size_t lost) {
  GltfMaker maker = identifiedSquare();
  maker.tree["meshes"][0]["primitives"][0]["extensions"][name] = extension;
  maker.tree["extensionsUsed"] = Json::array({name});
  const io::WrittenFiles files = written(maker.glb());
  const Json tree = treeOf(files.files[0]);
  CAPTURE(name);
  CHECK(saidLost(files) == lost);
  const Json& primitive = tree["meshes"][0]["primitives"][0];
  const Json left = primitive.value("extensions", Json::object());
  CHECK(tree.contains("extensionsUsed") == !left.empty());
  return left.value(name, Json());
}

}  // namespace

TEST_CASE("extensions: what counts vertices, triangles or accessors goes with them, and is said") {
  const Json numbers[] = {{{"indices", 3}},
                          {{"count", 1}, {"indicesOffsets", 3}, {"loopIndices", 3}},
                          {{"visibility", 2}},
                          {{"left", 0}},
                          {{"someone", {{"deep", {1.5, 2}}}}}};
  const char* names[] = {"CESIUM_primitive_outline", "EXT_mesh_polygon",
                         "EXT_mesh_primitive_edge_visibility", "CESIUM_tile_edges",
                         "ACME_never_heard_of"};
  for (std::size_t i = 0; i < std::size(names); ++i)
    CHECK(afterwards(names[i], numbers[i], 1).is_null());
  CHECK(afterwards("FB_ngon_encoding", Json::object(), 1).is_null());
}

TEST_CASE("extensions: what holds no number of anything that changed stays") {
  const Json mappings = {{"mappings", {{{"material", 0}, {"variants", {0}}}}}};
  CHECK(afterwards("KHR_materials_variants", mappings, 0) == mappings);
  const Json plain = {{"kind", "wall"}, {"shade", 0.5}};
  CHECK(afterwards("ACME_never_heard_of", plain, 0) == plain);
}

TEST_CASE("extensions: identifiers stay where their attribute or coordinates do") {
  const Json byAttribute = {{"featureIds", {{{"featureCount", 8}, {"attribute", 0}}}}};
  CHECK(afterwards("EXT_mesh_features", byAttribute, 0) == byAttribute);
  const Json texture = {{"index", 0}, {"texCoord", 0}, {"channels", {0}}};
  const Json byTexture = {{"featureIds", {{{"featureCount", 8}, {"texture", texture}}}}};
  CHECK(afterwards("EXT_mesh_features", byTexture, 0) == byTexture);
  Json elsewhere = byTexture;
  elsewhere["featureIds"][0]["texture"]["texCoord"] = 1;
  CHECK(afterwards("EXT_mesh_features", elsewhere, 1).is_null());
  const Json byNumber = {{"featureIds", {{{"featureCount", 4}}}}};
  CHECK(afterwards("EXT_mesh_features", byNumber, 1).is_null());
  const Json missing = {{"featureIds", {{{"featureCount", 8}, {"attribute", 1}}}}};
  CHECK(afterwards("EXT_mesh_features", missing, 1).is_null());
  Json several = byTexture;
  several["featureIds"].insert(several["featureIds"].begin(), byNumber["featureIds"][0]);
  CHECK(afterwards("EXT_mesh_features", several, 1) == byTexture);
}

TEST_CASE(
    "extensions: painted textures have other coordinates than what was looked up by the old") {
  const Json texture = {{"index", 0}, {"texCoord", 0}, {"channels", {0}}};
  const Json attributes = {{"POSITION", 0}, {"TEXCOORD_0", 1}, {"_FEATURE_ID_0", 2}};
  const auto settled = [&](const Json& extensions, io::LostExtensions& lost) {
    Json primitive = {{"attributes", attributes}, {"extensions", extensions}};
    const Json properties = {{"p", {{"index", 0}, {"texCoord", 0}}}};
    const Json named = {{"q", {{"attribute", "_FEATURE_ID_0"}}}};
    const Json tree = {{"extensions",
                        {{"EXT_structural_metadata",
                          {{"propertyTextures", {{{"properties", properties}}}},
                           {"propertyAttributes", {{{"properties", named}}}}}}}}};
    io::settlePrimitive(tree, primitive, io::Texcoords::Painted, lost);
    return primitive.value("extensions", Json::object());
  };
  io::LostExtensions lost;
  CHECK(settled({{"EXT_mesh_features", {{"featureIds", {{{"texture", texture}}}}}}}, lost).empty());
  CHECK(lost.count["EXT_mesh_features"] == 1);
  const Json both = {
      {"EXT_structural_metadata", {{"propertyTextures", {0}}, {"propertyAttributes", {0}}}}};
  CHECK(settled(both, lost) == Json{{"EXT_structural_metadata", {{"propertyAttributes", {0}}}}});
  CHECK(lost.count["EXT_structural_metadata"] == 1);
}

TEST_CASE("extensions: a mesh's own go too, with the accessors that only they named") {
  GltfMaker maker = identifiedSquare();
  const int merged = maker.add(std::vector<std::uint16_t>{0, 1}, kUShort, "SCALAR");
  maker.tree["meshes"][0]["extensions"]["EXT_mesh_manifold"] = {
      {"manifoldPrimitive", {{"indices", 3}, {"attributes", {{"POSITION", 1}}}}},
      {"mergeIndices", merged},
      {"mergeValues", merged}};
  maker.tree["extensionsUsed"] =
      Json::array({"EXT_mesh_manifold", "CESIUM_primitive_outline", "ACME_seen_nowhere"});
  const io::WrittenFiles files = written(maker.glb());
  const Json tree = treeOf(files.files[0]);
  CHECK(!tree["meshes"][0].contains("extensions"));
  CHECK(tree["accessors"].size() == maker.tree["accessors"].size() - 1);
  CHECK(tree["extensionsUsed"] == Json{"ACME_seen_nowhere"});
  CHECK(saidLost(files) == 1);
}

TEST_CASE("extensions: integers are declared as long as there are any") {
  GltfMaker maker;
  std::vector<std::int16_t> corners;
  for (const float x : kSquarePositions) corners.push_back(std::int16_t(3 * x));
  const int positions = maker.addAccessor({{"bufferView", maker.addView(bytesOf(corners))},
                                           {"componentType", kShort},
                                           {"count", 4},
                                           {"type", "VEC3"}});
  maker.addMesh({{{"attributes", {{"POSITION", positions}}},
                  {"indices", maker.add(kSquareIndices, kUShort, "SCALAR")}}});
  maker.show({{{"mesh", 0}}});
  for (const char* list : {"extensionsUsed", "extensionsRequired"})
    maker.tree[list] = Json::array({"KHR_mesh_quantization"});
  io::Model model = io::read(maker.glb());
  for (Vec3& p : model.parts[0].mesh.positions) p *= 0.3;  // no whole numbers
  const Json tree = treeOf(io::write(model, "out.glb").files[0]);
  CHECK(!tree.contains("extensionsUsed"));
  CHECK(!tree.contains("extensionsRequired"));
  Json kept = maker.tree;
  io::settleDeclarations(maker.tree, kept);
  CHECK(kept == maker.tree);
}

TEST_CASE("extensions: strips that begin anew are read where the file says that they may") {
  GltfMaker maker;
  const std::vector<std::uint16_t> strip = {0, 1, 3, 65535, 1, 2, 3};
  const int indices = maker.add(strip, kUShort, "SCALAR");
  maker.addMesh({{{"attributes", {{"POSITION", maker.add(kSquarePositions, kFloat, "VEC3")}}},
                  {"indices", indices},
                  {"mode", 5}}});
  maker.show({{{"mesh", 0}}});
  CHECK(readingFails(maker.glb()).find("INDEX_OUT_OF_RANGE") != std::string::npos);
  for (const char* list : {"extensionsUsed", "extensionsRequired"})
    maker.tree[list] = Json::array({"KHR_mesh_primitive_restart"});
  CHECK(io::read(maker.glb()).parts[0].mesh.indices == std::vector<Index>{0, 1, 3, 1, 2, 3});
  const Json tree = treeOf(written(maker.glb()).files[0]);
  CHECK(!tree.contains("extensionsRequired"));
  maker.tree["meshes"][0]["primitives"][0]["mode"] = 6;
  CHECK(io::read(maker.glb()).parts[0].mesh.indices == std::vector<Index>{1, 3, 0, 2, 3, 1});
}

TEST_CASE("extensions: data that only an unknown one may name stays, at its numbers") {
  CHECK(io::hiddenIn("MSFT_audio_emitter") == io::Hidden::Anything);
  CHECK(io::hiddenIn("MSFT_lod") == io::Hidden::Nothing);
  CHECK(io::hiddenIn("VRM") == io::Hidden::Looks);
  CHECK(io::hiddenIn("ACME_never_heard_of") == io::Hidden::Anything);
}
