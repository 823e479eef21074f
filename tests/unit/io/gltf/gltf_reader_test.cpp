// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>

#include "io/files.h"
#include "io/gltf/gltf.h"
#include "io/gltf/gltf_maker.h"

using namespace remesher;
using namespace remesher::test;

namespace {

const std::vector<Index> kSquare = {0, 1, 2, 0, 2, 3};

TriangleMesh onlyMesh(const File& file, const std::vector<File>& resources = {}) {
  const io::Model model = io::read(file, resources);
  REQUIRE(model.parts.size() == 1);
  return model.parts[0].mesh;
}

std::vector<float> valuesOf(const TriangleMesh& mesh, const std::string& semantic) {
  for (const Attribute& attribute : mesh.attributes)
    if (attribute.semantic == semantic) return attribute.values;
  return {};
}

// A square, its vertices in the order given, drawn in one of glTF's ways.
template <class Value>
GltfMaker squareOf(const std::vector<Value>& indices, int type, int mode) {
  GltfMaker maker;
  Json primitive = {{"attributes", {{"POSITION", maker.add(kSquarePositions, kFloat, "VEC3")}}},
                    {"indices", maker.add(indices, type, "SCALAR")},
                    {"mode", mode}};
  maker.addMesh({primitive});
  return maker;
}

GltfMaker squareWith(const std::string& semantic, const std::function<int(GltfMaker&)>& add) {
  GltfMaker maker = squareOf(kSquareIndices, kUShort, 4);
  maker.tree["meshes"][0]["primitives"][0]["attributes"][semantic] = add(maker);
  return maker;
}

}  // namespace

TEST_CASE("gltf: all index types, strips and fans read as the same triangles") {
  using U8 = std::vector<std::uint8_t>;
  using U32 = std::vector<std::uint32_t>;
  CHECK(onlyMesh(squareOf(U8{0, 1, 2, 0, 2, 3}, kUByte, 4).glb()).indices == kSquare);
  CHECK(onlyMesh(squareOf(kSquareIndices, kUShort, 4).glb()).indices == kSquare);
  CHECK(onlyMesh(squareOf(U32{0, 1, 2, 0, 2, 3}, kUInt, 4).glb()).indices == kSquare);
  CHECK(onlyMesh(squareOf(U8{1, 2, 0, 3}, kUByte, 5).glb()).indices ==
        std::vector<Index>{1, 2, 0, 2, 3, 0});
  CHECK(onlyMesh(squareOf(U8{0, 1, 2, 3}, kUByte, 6).glb()).indices ==
        std::vector<Index>{1, 2, 0, 2, 3, 0});
}

TEST_CASE("gltf: the triangles that stitch strips together are none") {
  const std::vector<std::uint8_t> stitched = {0, 1, 3, 3, 3, 1, 2};
  const TriangleMesh mesh = onlyMesh(squareOf(stitched, kUByte, 5).glb());
  CHECK(mesh.indices == std::vector<Index>{0, 1, 3, 3, 1, 2});
}

TEST_CASE("gltf: without indices every three vertices are a triangle") {
  GltfMaker maker;
  maker.addMesh({{{"attributes", {{"POSITION", maker.add(kSquarePositions, kFloat, "VEC3")}}}}});
  CHECK(onlyMesh(maker.glb()).indices == std::vector<Index>{0, 1, 2});
}

TEST_CASE("gltf: GLB, .gltf with a .bin and data URIs hold the same") {
  const GltfMaker maker = squareOf(kSquareIndices, kUShort, 4);
  const File bin{"made file.bin", maker.data};
  const File elsewhere{"folder/made file.bin", maker.data};
  for (const TriangleMesh& mesh : {onlyMesh(maker.glb()), onlyMesh(maker.embedded()),
                                   onlyMesh(maker.gltf("made%20file.bin"), {bin}),
                                   onlyMesh(maker.gltf("made file.bin"), {bin}),
                                   onlyMesh(maker.gltf("made%20file.bin"), {elsewhere})}) {
    CHECK(mesh.indices == kSquare);
    CHECK(mesh.positions[2] == Vec3(1, 1, 0));
  }
  CHECK(readingFails(maker.gltf("absent.bin")).find("MISSING_RESOURCE") == 0);
}

TEST_CASE("gltf: normalised integers are read as fractions") {
  const auto read = [](const Bytes& bytes, int type) {
    const GltfMaker maker =
        squareWith("_VALUE", [&](GltfMaker& m) { return m.addNormalized(bytes, type, "SCALAR"); });
    return valuesOf(onlyMesh(maker.glb()), "_VALUE");
  };
  using Floats = std::vector<float>;
  CHECK(read({0, 255, 51, 102}, kUByte) == Floats{0, 1, 0.2F, 0.4F});
  CHECK(read(bytesOf<std::int8_t>({0, 127, -127, -128}), kByte) == Floats{0, 1, -1, -1});
}

TEST_CASE("gltf: interleaved attributes are taken apart") {
  GltfMaker maker;
  const std::vector<float> interleaved = {0,    0,    0, 0.5F, 0.1F, 1,    0,   0,
                                          0.6F, 0.2F, 0, 1,    0,    0.7F, 0.3F};
  const int view = maker.addView(bytesOf(interleaved), 20);
  const Json position = {
      {"bufferView", view}, {"componentType", kFloat}, {"count", 3}, {"type", "VEC3"}};
  Json texcoord = position;
  texcoord["type"] = "VEC2";
  texcoord["byteOffset"] = 12;
  maker.addMesh({{{"attributes",
                   {{"POSITION", maker.addAccessor(position)},
                    {"TEXCOORD_0", maker.addAccessor(texcoord)}}}}});
  const TriangleMesh mesh = onlyMesh(maker.glb());
  CHECK(mesh.positions[1] == Vec3(1, 0, 0));
  CHECK(valuesOf(mesh, "TEXCOORD_0") == std::vector<float>{0.5F, 0.1F, 0.6F, 0.2F, 0.7F, 0.3F});
}

TEST_CASE("gltf: sparse accessors replace some values, of others or of zeros") {
  const auto sparse = [](GltfMaker& maker, Json accessor) {
    const int indices = maker.addView(bytesOf<std::uint16_t>({1, 3}));
    const int values = maker.addView(bytesOf<float>({7, 8}));
    accessor["componentType"] = kFloat;
    accessor["count"] = 4;
    accessor["type"] = "SCALAR";
    accessor["sparse"] = {{"count", 2},
                          {"indices", {{"bufferView", indices}, {"componentType", kUShort}}},
                          {"values", {{"bufferView", values}}}};
    return maker.addAccessor(accessor);
  };
  const GltfMaker onZeros = squareWith("_V", [&](GltfMaker& m) { return sparse(m, {}); });
  CHECK(valuesOf(onlyMesh(onZeros.glb()), "_V") == std::vector<float>{0, 7, 0, 8});
  const GltfMaker onOthers = squareWith("_V", [&](GltfMaker& m) {
    return sparse(m, {{"bufferView", m.addView(bytesOf<float>({1, 2, 3, 4}))}});
  });
  CHECK(valuesOf(onlyMesh(onOthers.glb()), "_V") == std::vector<float>{1, 7, 3, 8});
}

TEST_CASE("gltf: morph targets are attributes named by their number") {
  GltfMaker maker = squareOf(kSquareIndices, kUShort, 4);
  const std::vector<float> rise = {0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0, 4};
  maker.tree["meshes"][0]["primitives"][0]["targets"] = {
      {{"POSITION", maker.add(rise, kFloat, "VEC3")}}};
  CHECK(valuesOf(onlyMesh(maker.glb()), "TARGET_0/POSITION") == rise);
}

TEST_CASE("gltf: primitives are groups; those naming the same accessors share vertices") {
  GltfMaker maker;
  const int positions = maker.add(kSquarePositions, kFloat, "VEC3");
  const int others = maker.add(kSquarePositions, kFloat, "VEC3");
  const int colors = maker.add(std::vector<float>(12, 0.5F), kFloat, "VEC3");
  const int first = maker.add(std::vector<std::uint16_t>{0, 1, 2}, kUShort, "SCALAR");
  const int second = maker.add(std::vector<std::uint16_t>{0, 2, 3}, kUShort, "SCALAR");
  maker.addMesh(
      {{{"attributes", {{"POSITION", positions}}}, {"indices", first}},
       {{"attributes", {{"POSITION", positions}}}, {"mode", 0}},
       {{"attributes", {{"POSITION", positions}}}, {"indices", second}},
       {{"attributes", {{"POSITION", others}, {"COLOR_0", colors}}}, {"indices", second}}});
  const io::Model model = io::read(maker.glb());
  const TriangleMesh& mesh = model.parts[0].mesh;
  CHECK(mesh.groups == std::vector<Index>{0, 2, 3});
  CHECK(mesh.indices == std::vector<Index>{0, 1, 2, 0, 2, 3, 4, 6, 7});
  const std::vector<float> values = valuesOf(mesh, "COLOR_0");
  CHECK(values[0] == 1.0F);  // absent there: white
  CHECK(values[12] == 0.5F);
  REQUIRE(model.warnings.size() == 1);
  CHECK(model.warnings[0].code == "NOT_TRIANGLES");
  CHECK(model.warnings[0].count == 1);
}

TEST_CASE("gltf: instances stand where the nodes put them") {
  GltfMaker maker = squareOf(kSquareIndices, kUShort, 4);
  maker.show({{{"mesh", 0}, {"translation", {5, 0, 0}}}, {{"mesh", 0}, {"scale", {2, 3, -4}}}});
  maker.tree["nodes"][1]["children"] = {2};
  maker.tree["nodes"].push_back(
      {{"mesh", 0}, {"rotation", {0, 0, std::sqrt(0.5), std::sqrt(0.5)}}});
  const io::Model model = io::read(maker.glb());
  REQUIRE(model.parts[0].instances.size() == 3);
  const Vec3 corner(1, 0, 0);
  CHECK((model.parts[0].instances[0] * corner - Vec3(6, 0, 0)).norm() < 1e-12);
  CHECK((model.parts[0].instances[1] * corner - Vec3(2, 0, 0)).norm() < 1e-12);
  CHECK((model.parts[0].instances[2] * corner - Vec3(0, 3, 0)).norm() < 1e-12);
}

TEST_CASE("gltf: a mesh with joints stands where its skin carries it, not where its node is") {
  GltfMaker maker = squareOf(kSquareIndices, kUShort, 4);
  maker.show(
      {{{"mesh", 0}, {"skin", 0}, {"translation", {100, 0, 0}}}, {{"translation", {0, 7, 0}}}});
  const int inverseBind = maker.addAccessor(
      {{"bufferView",
        maker.addView(bytesOf<float>({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -5, 0, 1}))},
       {"componentType", kFloat},
       {"count", 1},
       {"type", "MAT4"}});
  maker.tree["skins"] = Json::array({{{"joints", {1}}, {"inverseBindMatrices", inverseBind}}});
  const auto place = [&]() -> Vec3 {
    return io::read(maker.glb()).parts[0].instances[0].translation();
  };
  CHECK(place() == Vec3(100, 0, 0));  // without joints the skin means nothing
  Json& attributes = maker.tree["meshes"][0]["primitives"][0]["attributes"];
  attributes["JOINTS_0"] = maker.add(Bytes(16, 0), kUByte, "VEC4");
  attributes["WEIGHTS_0"] = maker.add(std::vector<float>(16, 0.25F), kFloat, "VEC4");
  CHECK(place() == Vec3(0, 2, 0));
}

TEST_CASE("gltf: without a scene every mesh is shown once, where it is") {
  const io::Model model = io::read(squareOf(kSquareIndices, kUShort, 4).glb());
  REQUIRE(model.parts[0].instances.size() == 1);
  CHECK(model.parts[0].instances[0].matrix() == Eigen::Matrix4d::Identity());
}

TEST_CASE("gltf: attributes of a type they cannot have are left out, and said to be") {
  for (const char* semantic : {"NORMAL", "TANGENT", "TEXCOORD_0", "COLOR_0", "JOINTS_0"}) {
    GltfMaker maker = squareOf(kSquareIndices, kUShort, 4);
    maker.tree["meshes"][0]["primitives"][0]["attributes"][semantic] =
        maker.add(std::vector<float>{1, 2, 3, 4}, kFloat, "SCALAR");
    const io::Model model = io::read(maker.glb());
    CHECK(model.parts[0].mesh.attributes.empty());
    REQUIRE(model.warnings.size() == 1);
    CHECK(model.warnings[0].code == "ATTRIBUTE_NOT_CARRIED");
    for (const char* output : {"out.glb", "out.obj", "out.off"})
      CHECK(!io::read(io::write(model, output).files[0]).parts.empty());
  }
}

TEST_CASE("gltf: joints that the skin has not bind nothing") {
  GltfMaker maker = squareOf(kSquareIndices, kUShort, 4);
  Json& attributes = maker.tree["meshes"][0]["primitives"][0]["attributes"];
  attributes["JOINTS_0"] =
      maker.add(Bytes{0, 1, 0, 0, 1, 9, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0}, kUByte, "VEC4");
  attributes["WEIGHTS_0"] = maker.add(std::vector<float>(16, 0.25F), kFloat, "VEC4");
  maker.show({{{"mesh", 0}, {"skin", 0}}, Json::object(), Json::object()});
  maker.tree["skins"] = Json::array({{{"joints", {1, 2}}}});
  const io::Model model = io::read(maker.glb());
  const std::vector<Attribute>& read = model.parts[0].mesh.attributes;
  CHECK(read[0].values == std::vector<float>{0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  CHECK(read[1].values[5] == 0);
  CHECK(read[1].values[12] == 0);
  const std::vector<float> rest(read[1].values.begin() + 4, read[1].values.begin() + 8);
  CHECK(rest[0] == doctest::Approx(1.0 / 3));
  CHECK(rest[0] + rest[1] + rest[2] + rest[3] == doctest::Approx(1));
  CHECK(read[1].values[8] == 1);  // four times the same joint
  REQUIRE(model.warnings.size() == 1);
  CHECK(model.warnings[0].code == "JOINT_NOT_IN_SKIN");
  CHECK(model.warnings[0].count == 2);
  CHECK(io::read(io::write(model, "out.glb").files[0]).warnings.empty());
}

TEST_CASE("gltf: a joint that a vertex is bound to twice has both weights once") {
  GltfMaker maker = squareOf(kSquareIndices, kUShort, 4);
  Json& attributes = maker.tree["meshes"][0]["primitives"][0]["attributes"];
  attributes["JOINTS_0"] =
      maker.add(Bytes{1, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0}, kUByte, "VEC4");
  attributes["WEIGHTS_0"] = maker.add(
      std::vector<float>{0.5F, 0.25F, 0.25F, 0, 0.5F, 0.5F, 0, 0, 1, 0, 0, 0, 0.5F, 0.5F, 0, 0},
      kFloat, "VEC4");
  maker.show({{{"mesh", 0}, {"skin", 0}}, Json::object(), Json::object()});
  maker.tree["skins"] = Json::array({{{"joints", {1, 2}}}});
  const std::vector<Attribute> read = io::read(maker.glb()).parts[0].mesh.attributes;
  CHECK(read[0].values == std::vector<float>{1, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  CHECK(read[1].values ==
        std::vector<float>{0.75F, 0.25F, 0, 0, 0.5F, 0.5F, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
}

TEST_CASE("gltf: images that another format has no place for are said to be lost") {
  GltfMaker maker = squareOf(kSquareIndices, kUShort, 4);
  maker.show({{{"mesh", 0}}});
  maker.tree["images"] = {{{"uri", "a.png"}}};
  maker.tree["textures"] = {{{"source", 0}}};
  maker.tree["materials"] = {{{"normalTexture", {{"index", 0}}}}};
  maker.tree["meshes"][0]["primitives"][0]["material"] = 0;
  const io::Model model = io::read(maker.glb());
  const auto warningsOf = [&](const char* name) {
    std::size_t count = 0;
    for (const Warning& warning : io::write(model, name).warnings)
      count += warning.code == "MATERIAL_IMAGES_NOT_READ" ? 1 : 0;
    return count;
  };
  for (const char* name : {"a.obj", "a.ply", "a.stl", "a.off"}) CHECK(warningsOf(name) == 1);
  for (const char* name : {"a.glb", "a.gltf"}) CHECK(warningsOf(name) == 0);
}
