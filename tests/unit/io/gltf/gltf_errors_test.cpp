// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <limits>

#include "io/files.h"
#include "io/gltf/gltf_maker.h"

using namespace remesher;
using namespace remesher::test;

namespace {

GltfMaker square() {
  GltfMaker maker;
  maker.addMesh({{{"attributes", {{"POSITION", maker.add(kSquarePositions, kFloat, "VEC3")}}},
                  {"indices", maker.add(kSquareIndices, kUShort, "SCALAR")}}});
  maker.show({{{"mesh", 0}}});
  return maker;
}

// What reading says after `damage` was done to the tree of a good file.
std::string failureAfter(const std::function<void(Json&)>& damage) {
  GltfMaker maker = square();
  damage(maker.tree);
  return readingFails(maker.glb());
}

void checkContains(const std::string& text, std::string_view part) {
  CAPTURE(text);
  CHECK(text.find(part) != std::string::npos);
}

}  // namespace

TEST_CASE("gltf: every truncation of a file is refused in a sentence") {
  const File whole = square().glb();
  REQUIRE(readingFails(whole).empty());
  for (std::size_t size = 1; size < whole.bytes.size(); ++size) {
    File part = whole;
    part.bytes.resize(size);
    CHECK(readingFails(part).find("PARSE_ERROR made.glb: ") == 0);
  }
}

TEST_CASE("gltf: what is no glTF is refused") {
  checkContains(readingFails(textFile("a.glb", "Dear diary")), "does not begin as a binary glTF");
  checkContains(readingFails(textFile("a.gltf", "{\"a\": ")), "the JSON is broken at byte 7");
  checkContains(readingFails(textFile("a.gltf", "[1]")), "it has no \"asset\"");
  checkContains(readingFails(textFile("a.gltf", "{\"asset\": {\"version\": \"1.0\"}}")),
                "UNSUPPORTED");
  checkContains(readingFails(textFile("a.gltf", std::string(100000, '['))), "nests deeper");
}

TEST_CASE("gltf: accessors that promise what is not there are refused by number") {
  checkContains(failureAfter([](Json& t) { t["accessors"][0]["count"] = 5; }),
                "accessor 0 reaches beyond its buffer view");
  checkContains(failureAfter([](Json& t) { t["accessors"][0]["count"] = 1ULL << 62; }),
                "accessor 0 claims");
  checkContains(failureAfter([](Json& t) { t["accessors"][0]["byteOffset"] = ~0ULL - 3; }),
                "accessor 0 reaches beyond");
  checkContains(failureAfter([](Json& t) { t["accessors"][0]["bufferView"] = 9; }),
                "refers to buffer view 9, which is not there");
  checkContains(failureAfter([](Json& t) { t["accessors"][0]["componentType"] = 5130; }),
                "accessor 0 has a component type");
  checkContains(failureAfter([](Json& t) { t["accessors"][0]["componentType"] = 77; }),
                "componentType` in accessor. Got 77.");
  checkContains(failureAfter([](Json& t) { t["accessors"][0]["type"] = "VEC9"; }), "Got \"VEC9\".");
  checkContains(failureAfter([](Json& t) { t["accessors"][1]["componentType"] = test::kShort; }),
                "accessor 1 holds indices");
  checkContains(failureAfter([](Json& t) { t["bufferViews"][0]["byteLength"] = 1 << 20; }),
                "buffer view 0 reaches beyond its buffer");
  checkContains(failureAfter([](Json& t) { t["bufferViews"][0]["buffer"] = 1; }),
                "buffer view 0 reaches beyond its buffer");
  checkContains(failureAfter([](Json& t) { t["accessors"][0]["type"] = "VEC2"; }),
                "positions have not three coordinates");
  checkContains(
      failureAfter([](Json& t) { t["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = 7; }),
      "accessor 7, which is not there");
}

TEST_CASE("gltf: buffer views whose numbers have fractions or too many digits are refused") {
  for (const char* member : {"buffer", "byteOffset", "byteLength", "byteStride"})
    for (const Json& bad : {Json(1e6), Json(1LL << 32), Json(-1), Json("0")}) {
      if (member == std::string("byteStride") && bad.is_number_unsigned()) continue;
      const std::string failure = failureAfter([&](Json& t) { t["bufferViews"][0][member] = bad; });
      CAPTURE(member);
      CAPTURE(bad.dump());
      CHECK(failure.find("PARSE_ERROR made.glb") == 0);
    }
}

TEST_CASE("gltf: whatever refers to accessors or buffer views that are not there is refused") {
  const auto failureWith = [](const char* member, const Json& value) {
    return failureAfter([&](Json& t) { t[member] = value; });
  };
  checkContains(failureWith("skins", {{{"inverseBindMatrices", 2}}}),
                "refers to accessor 2, which is not there");
  checkContains(failureWith("images", {{{"bufferView", 2}}}),
                "refers to buffer view 2, which is not there");
  checkContains(failureWith("images", {{{"bufferView", 0.5}}}),
                "refers to buffer view by what is no number");
  const Json targets = {7, {{"A", 0}}};
  checkContains(
      failureAfter([&](Json& t) { t["meshes"][0]["primitives"][0]["targets"] = targets; }),
      "morph targets are no list of attributes");
}

TEST_CASE("gltf: primitives that are none are refused, for those behind them have their numbers") {
  for (const Json& bad : {Json{{"attributes", true}}, Json{{"mode", 4}}, Json(7)})
    checkContains(failureAfter([&](Json& t) {
                    Json& primitives = t["meshes"][0]["primitives"];
                    primitives.insert(primitives.begin(), bad);
                  }),
                  "a primitive of it has no attributes");
}

TEST_CASE("gltf: what the JSON library finds wrong is said in a sentence") {
  checkContains(failureAfter([](Json& t) { t["accessors"][0]["bufferView"] = -5; }), ". | ");
  checkContains(failureAfter([](Json& t) { t["meshes"] = 5; }), ". | ");
}

TEST_CASE("gltf: nodes that put triangles at no finite place are refused") {
  checkContains(failureAfter([](Json& t) {
                  t["nodes"][0]["scale"] = {1e300, 1, 1};
                  t["nodes"].push_back({{"children", {0}}, {"scale", {1e300, 1, 1}}});
                  t["scenes"][0]["nodes"] = {1};
                }),
                "NON_FINITE made.glb: its nodes put mesh 0 at places that are not finite");
}

TEST_CASE("gltf: indices out of range and coordinates that are not finite are located") {
  GltfMaker outside;
  outside.addMesh(
      {{{"attributes", {{"POSITION", outside.add(kSquarePositions, kFloat, "VEC3")}}},
        {"indices", outside.add(std::vector<std::uint16_t>{0, 1, 4}, kUShort, "SCALAR")}}});
  checkContains(readingFails(outside.glb()),
                "INDEX_OUT_OF_RANGE made.glb: mesh 0, primitive 0: index 2 names vertex 4");
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    GltfMaker maker;
    maker.addMesh({{{"attributes",
                     {{"POSITION", maker.add(std::vector<float>{0, 0, 0, 1, 0, bad, 0, 1, 0},
                                             kFloat, "VEC3")}}}}});
    checkContains(readingFails(maker.glb()),
                  "NON_FINITE made.glb: mesh 0, primitive 0: the position of vertex 1");
  }
}

TEST_CASE("gltf: nodes that are no tree are refused") {
  checkContains(failureAfter([](Json& t) { t["nodes"][0]["children"] = {0}; }),
                "node 0 hangs in the scene more than once");
  checkContains(failureAfter([](Json& t) { t["nodes"][0]["children"] = {3}; }),
                "node 3, which is not there");
  checkContains(failureAfter([](Json& t) { t["nodes"][0]["mesh"] = 3; }),
                "mesh 3, which is not there");
}

TEST_CASE("gltf: compressed files are for the bindings to decompress") {
  checkContains(failureAfter([](Json& t) { t["extensionsUsed"] = {"KHR_draco_mesh_compression"}; }),
                "UNSUPPORTED made.glb: the file is compressed with KHR_draco_mesh_compression");
}

TEST_CASE("gltf: values that are not finite in other attributes are read as 0 and reported") {
  GltfMaker maker = square();
  maker.tree["meshes"][0]["primitives"][0]["attributes"]["_V"] =
      maker.add(std::vector<float>{1, NAN, INFINITY, 2}, kFloat, "SCALAR");
  const io::Model model = io::read(maker.glb());
  CHECK(model.parts[0].mesh.attributes[0].values == std::vector<float>{1, 0, 0, 2});
  REQUIRE(model.warnings.size() == 1);
  CHECK(model.warnings[0].count == 2);
}
