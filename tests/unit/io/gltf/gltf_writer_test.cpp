// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "io/files.h"
#include "io/gltf/gltf.h"
#include "io/gltf/gltf_accessor.h"
#include "io/gltf/gltf_maker.h"

using namespace remesher;
using namespace remesher::test;

namespace {

// The triangles in reverse order: another mesh with the same vertices.
void replaceMesh(io::Part& part) {
  std::vector<Index>& indices = part.mesh.indices;
  for (std::size_t i = 0, j = indices.size() - 3; i < j; i += 3, j -= 3)
    std::swap_ranges(indices.begin() + std::ptrdiff_t(i), indices.begin() + std::ptrdiff_t(i + 3),
                     indices.begin() + std::ptrdiff_t(j));
  std::reverse(part.mesh.groups.begin(), part.mesh.groups.end());
}

io::Model replaced(const File& file, const std::vector<File>& resources = {}) {
  io::Model model = io::read(file, resources);
  for (io::Part& part : model.parts) replaceMesh(part);
  return model;
}

File rewritten(const GltfMaker& maker) {
  return io::write(replaced(maker.glb()), "out.glb").files[0];
}

Json accessorOf(const Json& tree, const std::string& semantic, int mesh = 0) {
  return tree["accessors"]
             [tree["meshes"][mesh]["primitives"][0]["attributes"][semantic].get<int>()];
}

// A square with an accessor of every kind: float, normalised and plain integers, in all widths.
GltfMaker squareOfAllKinds() {
  GltfMaker maker;
  const int normals =
      maker.add(std::vector<std::int8_t>{0, 0, 127, 0, 0, 0, 127, 0, 0, 0, 127, 0, 0, 0, 127, 0},
                kByte, "VEC4");
  maker.tree["accessors"][normals]["normalized"] = true;
  maker.tree["accessors"][normals]["type"] = "VEC3";
  maker.tree["bufferViews"][0]["byteStride"] = 4;
  maker.addMesh(
      {{{"attributes",
         {{"NORMAL", normals},
          {"TANGENT",
           maker.add(std::vector<float>{1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, -1, 1, 0, 0, -1}, kFloat,
                     "VEC4")},
          {"POSITION", maker.add(kSquarePositions, kFloat, "VEC3")},
          {"TEXCOORD_0",
           maker.addNormalized(bytesOf<std::uint16_t>({0, 0, 65535, 0, 65535, 65535, 0, 65535}),
                               kUShort, "VEC2")},
          {"COLOR_0", maker.addNormalized(Bytes(16, 51), kUByte, "VEC4")},
          {"JOINTS_0",
           maker.add(Bytes{0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3}, kUByte, "VEC4")},
          {"WEIGHTS_0",
           maker.addNormalized(Bytes{85, 85, 85, 0, 255, 0, 0, 0, 128, 127, 0, 0, 64, 64, 64, 63},
                               kUByte, "VEC4")},
          {"_HEAT", maker.add(std::vector<float>{1, 2, 3, 4}, kFloat, "SCALAR")}}},
        {"targets",
         {{{"POSITION", maker.add(std::vector<float>(12, 0.5F), kFloat, "VEC3")},
           {"NORMAL", maker.add(std::vector<float>(12, 0.25F), kFloat, "VEC3")}}}},
        {"indices", maker.add(kSquareIndices, kUShort, "SCALAR")}}});
  maker.tree["accessors"][2]["name"] = "corners";
  // addNormalized counts bytes; these are twice as wide.
  maker.tree["accessors"][3]["count"] = 4;
  return maker;
}

void checkSameMesh(const TriangleMesh& a, const TriangleMesh& b) {
  CHECK(a.positions == b.positions);
  CHECK(a.indices == b.indices);
  CHECK(a.groups == b.groups);
  REQUIRE(a.attributes.size() == b.attributes.size());
  for (std::size_t i = 0; i < a.attributes.size(); ++i) {
    CHECK(a.attributes[i].semantic == b.attributes[i].semantic);
    CHECK(a.attributes[i].values == b.attributes[i].values);
  }
}

}  // namespace

TEST_CASE("gltf: a file in which nothing was replaced comes back byte for byte") {
  const GltfMaker maker = squareOfAllKinds();
  CHECK(io::write(io::read(maker.glb()), "out.glb").files[0].bytes == maker.glb().bytes);
  const File bin{"made.bin", maker.data};
  const io::WrittenFiles text = io::write(io::read(maker.gltf("made.bin"), {bin}), "out.gltf");
  REQUIRE(text.files.size() == 2);
  CHECK(text.files[0].bytes == maker.gltf("made.bin").bytes);
  CHECK(text.files[1].name == "made.bin");
  CHECK(text.files[1].bytes == maker.data);
  GltfMaker points;
  points.addMesh({{{"attributes", {{"POSITION", points.add(kSquarePositions, kFloat, "VEC3")}}},
                   {"mode", 0}}});
  CHECK(io::write(io::read(points.glb()), "out.glb").files[0].bytes == points.glb().bytes);
}

TEST_CASE("gltf: a replaced mesh reads back as itself, in the encodings the file had") {
  const GltfMaker maker = squareOfAllKinds();
  const io::Model model = replaced(maker.glb());
  const File file = io::write(model, "out.glb").files[0];
  checkSameMesh(io::read(file).parts[0].mesh, model.parts[0].mesh);
  const Json before = maker.tree, after = treeOf(file);
  for (const auto& attribute : before["meshes"][0]["primitives"][0]["attributes"].items()) {
    const std::string& semantic = attribute.key();
    CAPTURE(semantic);
    const Json old = accessorOf(before, semantic), now = accessorOf(after, semantic);
    for (const char* member : {"componentType", "normalized", "type", "name"})
      CHECK(old.value(member, Json()) == now.value(member, Json()));
  }
  CHECK(accessorOf(after, "POSITION")["max"] == Json{1.0, 1.0, 0.0});
}

TEST_CASE("gltf: what replaced accessors leave behind is gone") {
  const GltfMaker maker = squareOfAllKinds();
  const Json after = treeOf(rewritten(maker));
  CHECK(after["accessors"].size() == maker.tree["accessors"].size());
  CHECK(after["bufferViews"].size() == maker.tree["bufferViews"].size());
  CHECK(rewritten(maker).bytes.size() < maker.glb().bytes.size() + 1024);
}

TEST_CASE("gltf: all .gltf and GLB conversions hold the same scene") {
  const GltfMaker maker = squareOfAllKinds();
  const File bin{"made.bin", maker.data};
  const TriangleMesh mesh = io::read(maker.glb()).parts[0].mesh;
  for (const io::Model& model : {io::read(maker.glb()), io::read(maker.embedded()),
                                 io::read(maker.gltf("made.bin"), {bin})}) {
    const io::WrittenFiles text = io::write(model, "folder/some file.gltf");
    const std::vector<File> beside(text.files.begin() + 1, text.files.end());
    checkSameMesh(io::read(text.files[0], beside).parts[0].mesh, mesh);
    checkSameMesh(io::read(io::write(model, "out.glb").files[0]).parts[0].mesh, mesh);
  }
  const io::WrittenFiles split = io::write(io::read(maker.glb()), "folder/some file.gltf");
  REQUIRE(split.files.size() == 2);
  CHECK(split.files[1].name == "some file.bin");
  CHECK(io::write(io::read(maker.embedded()), "out.gltf").files.size() == 1);
}

TEST_CASE("gltf: the scene around replaced triangles keeps its tree and its bytes") {
  GltfMaker maker = squareOfAllKinds();
  const Bytes image = {0x89, 'P', 'N', 'G', 1, 2, 3, 4, 5, 6, 7};
  const int keyTimes = maker.add(std::vector<float>{0, 1}, kFloat, "SCALAR");
  const int keys = maker.add(std::vector<float>{0, 0, 0, 1, 1, 1}, kFloat, "VEC3");
  maker.tree["images"] = {{{"bufferView", maker.addView(image)}, {"mimeType", "image/png"}}};
  maker.tree["textures"] = {{{"source", 0}}};
  maker.tree["materials"] = {
      {{"name", "m"},
       {"pbrMetallicRoughness",
        {{"baseColorTexture",
          {{"index", 0}, {"extensions", {{"KHR_texture_transform", {{"offset", {0.5, 0.25}}}}}}}}}},
       {"extras", {{"vendor", {1, 2, 3}}}}}};
  maker.tree["cameras"] = {
      {{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}}};
  maker.tree["animations"] = {
      {{"samplers", {{{"input", keyTimes}, {"output", keys}}}},
       {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}}};
  maker.tree["meshes"][0]["primitives"][0]["material"] = 0;
  maker.tree["meshes"][0]["extras"] = {{"targetNames", {"rise"}}};
  maker.show(
      {{{"mesh", 0}, {"name", "a"}}, {{"mesh", 0}, {"translation", {1, 2, 3.5}}}, {{"camera", 0}}});
  maker.tree["extensionsUsed"] = {"KHR_texture_transform", "ACME_unknown"};
  maker.tree["extensions"] = {{"ACME_unknown", {{"motto", "keep me"}}}};
  const File file = rewritten(maker);
  const Json after = treeOf(file);
  for (const char* member : {"materials", "textures", "cameras", "nodes", "scenes", "scene",
                             "asset", "extensions", "extensionsUsed"}) {
    CAPTURE(member);
    CHECK(after[member] == maker.tree[member]);
  }
  CHECK(after["meshes"][0]["extras"] == maker.tree["meshes"][0]["extras"]);
  CHECK(after["meshes"][0]["primitives"][0]["material"] == 0);
  const auto document = io::openGltf(file, {});
  const Json view = after["bufferViews"][after["images"][0]["bufferView"].get<int>()];
  Bytes shown;
  io::appendRange(shown, document->buffers[0], view["byteOffset"], view["byteLength"]);
  CHECK(shown == image);
  const int output = after["animations"][0]["samplers"][0]["output"].get<int>();
  CHECK(io::readFloats(*document, output, 2) == std::vector<float>{0, 0, 0, 1, 1, 1});
}

TEST_CASE("gltf: where an unknown extension may name accessors, none is renumbered") {
  GltfMaker maker = squareOfAllKinds();
  const int secret = maker.add(std::vector<float>{42}, kFloat, "SCALAR");
  maker.tree["extensions"] = {{"ACME_secret", {{"accessor", secret}}}};
  const File file = rewritten(maker);
  CHECK(treeOf(file)["accessors"].size() > maker.tree["accessors"].size());
  CHECK(io::readFloats(*io::openGltf(file, {}), secret, 1) == std::vector<float>{42});
}

TEST_CASE("gltf: accessors shared with a mesh that was not replaced stay") {
  GltfMaker maker = squareOfAllKinds();
  maker.tree["meshes"].push_back(maker.tree["meshes"][0]);
  io::Model model = io::read(maker.glb());
  REQUIRE(model.parts.size() == 2);
  replaceMesh(model.parts[0]);
  const io::Model again = io::read(io::write(model, "out.glb").files[0]);
  checkSameMesh(again.parts[0].mesh, model.parts[0].mesh);
  checkSameMesh(again.parts[1].mesh, model.parts[1].mesh);
}

TEST_CASE("gltf: rounded weights still sum to one") {
  io::Model model = io::read(squareOfAllKinds().glb());
  replaceMesh(model.parts[0]);
  for (Attribute& attribute : model.parts[0].mesh.attributes)
    if (attribute.semantic == "WEIGHTS_0")
      attribute.values = {1 / 3.0F, 1 / 3.0F, 1 / 3.0F, 0,    0.5F, 0.5F, 0, 0,
                          0.1F,     0.2F,     0.3F,     0.4F, 1,    0,    0, 0};
  const io::Model again = io::read(io::write(model, "out.glb").files[0]);
  for (const Attribute& attribute : again.parts[0].mesh.attributes)
    if (attribute.semantic == "WEIGHTS_0")
      for (std::size_t i = 0; i < 16; i += 4)
        CHECK(std::lround(255 * std::accumulate(attribute.values.begin() + std::ptrdiff_t(i),
                                                attribute.values.begin() + std::ptrdiff_t(i + 4),
                                                0.0F)) == 255);
}

TEST_CASE("gltf: a joint whose weight is rounded to nothing is none") {
  io::Model model = io::read(squareOfAllKinds().glb());
  replaceMesh(model.parts[0]);
  for (Attribute& attribute : model.parts[0].mesh.attributes)
    if (attribute.semantic == "WEIGHTS_0")
      for (std::size_t i = 0; i < 16; ++i) attribute.values[i] = i % 4 == 1 ? 1e-3F : 0.333F;
  const io::Model again = io::read(io::write(model, "out.glb").files[0]);
  const TriangleMesh& mesh = again.parts[0].mesh;
  CHECK(findAttribute(mesh, "WEIGHTS_0")->values[1] == 0);
  CHECK(findAttribute(mesh, "JOINTS_0")->values ==
        std::vector<float>{0, 0, 2, 3, 0, 0, 2, 3, 0, 0, 2, 3, 0, 0, 2, 3});
}

TEST_CASE("gltf: weights that are not one for each morph target go") {
  for (const Json& weights : {Json::array({0.5}), Json::array({0.5, 0.5})}) {
    GltfMaker maker = squareOfAllKinds();
    maker.tree["meshes"][0]["weights"] = weights;
    maker.tree["nodes"] = Json::array({{{"mesh", 0}, {"weights", weights}}});
    const Json tree = treeOf(rewritten(maker));
    CHECK(tree["meshes"][0].contains("weights") == (weights.size() == 1));
    CHECK(tree["nodes"][0].contains("weights") == (weights.size() == 1));
  }
}

TEST_CASE("gltf: quantised positions are integers again only where these are what they are") {
  const auto componentType = [](double moved) {
    GltfMaker maker;
    const std::vector<std::uint16_t> positions = {0, 0, 0, 0, 9000, 0, 0, 0, 9000, 9000, 0, 0};
    const int accessor = maker.addAccessor({{"bufferView", maker.addView(bytesOf(positions), 8)},
                                            {"componentType", kUShort},
                                            {"count", 3},
                                            {"type", "VEC3"}});
    maker.addMesh({{{"attributes", {{"POSITION", accessor}}}}});
    io::Model model = io::read(maker.glb());
    CHECK(model.parts[0].mesh.positions[1] == Vec3(9000, 0, 0));
    model.parts[0].mesh.positions[1].x() -= moved;
    const File file = io::write(model, "out.glb").files[0];
    CHECK(io::read(file).parts[0].mesh.positions[1] == Vec3(9000 - moved, 0, 0));
    return accessorOf(treeOf(file), "POSITION")["componentType"].get<int>();
  };
  CHECK(componentType(1) == kUShort);
  CHECK(componentType(0.25) == kFloat);
}

TEST_CASE("gltf: vertices on a border of two primitives coincide bit for bit") {
  GltfMaker maker;
  const auto add = [&](const std::vector<float>& positions, bool isColored) {
    Json attributes = {{"POSITION", maker.add(positions, kFloat, "VEC3")}};
    if (isColored) attributes["COLOR_0"] = maker.addNormalized(Bytes(12, 9), kUByte, "VEC4");
    return Json{{"attributes", attributes}};
  };
  maker.addMesh({add({0, 0, 0, 1, 0, 0, 1, 1, 0}, true), add({0, 0, 0, 1, 1, 0, 0, 1, 0}, false)});
  io::Model model = io::read(maker.glb());
  TriangleMesh& mesh = model.parts[0].mesh;
  mesh.positions[2] = mesh.positions[4] = Vec3(0.1, 1 / 3.0, 0.7);
  const File file = io::write(model, "out.glb").files[0];
  const TriangleMesh again = io::read(file).parts[0].mesh;
  CHECK(again.positions[2] == again.positions[4]);
  CHECK(again.groups == std::vector<Index>{0, 1});
  const Json second = treeOf(file)["meshes"][0]["primitives"][1]["attributes"];
  CHECK(second.size() == 1);  // what it did not have it does not get
}

TEST_CASE("gltf: a vertex may serve triangles of two primitives") {
  GltfMaker maker;
  const int positions = maker.add(kSquarePositions, kFloat, "VEC3");
  const Json attributes = {{"POSITION", positions}};
  maker.addMesh({{{"attributes", attributes},
                  {"indices", maker.add(std::vector<std::uint8_t>{0, 1, 2}, kUByte, "SCALAR")}},
                 {{"attributes", attributes},
                  {"indices", maker.add(std::vector<std::uint8_t>{0, 2, 3}, kUByte, "SCALAR")}}});
  io::Model model = io::read(maker.glb());
  model.parts[0].mesh.positions[0].z() = 0.5;
  const File file = io::write(model, "out.glb").files[0];
  checkSameMesh(io::read(file).parts[0].mesh, model.parts[0].mesh);
  CHECK(treeOf(file)["accessors"].size() == 3);  // still shared
}

TEST_CASE("gltf: a primitive that lost all its triangles goes, an attribute that is lost goes") {
  GltfMaker maker = squareOfAllKinds();
  Json primitive = maker.tree["meshes"][0]["primitives"][0];
  primitive["material"] = 1;
  maker.tree["meshes"][0]["primitives"].push_back(primitive);
  maker.tree["materials"] = {{{"name", "first"}}, {{"name", "second"}}};
  io::Model model = io::read(maker.glb());
  TriangleMesh& mesh = model.parts[0].mesh;
  mesh.indices.erase(mesh.indices.begin(), mesh.indices.begin() + 6);
  mesh.groups.erase(mesh.groups.begin(), mesh.groups.begin() + 2);
  mesh.attributes.clear();
  const Json after = treeOf(io::write(model, "out.glb").files[0]);
  REQUIRE(after["meshes"][0]["primitives"].size() == 1);
  const Json left = after["meshes"][0]["primitives"][0];
  CHECK(left["material"] == 1);
  CHECK(left["attributes"].size() == 1);
  CHECK(left["targets"].size() == 1);  // animations count targets: they become zero instead
}

TEST_CASE("gltf: images beside a .gltf are passed on, and go into a GLB") {
  GltfMaker maker = squareOfAllKinds();
  maker.tree["images"] = {{{"uri", "my%20image.png"}}, {{"uri", "absent.png"}}};
  const std::vector<File> resources = {{"made.bin", maker.data},
                                       {"my image.png", {0x89, 'P', 'N', 'G', 5, 6}}};
  const io::Model model = replaced(maker.gltf("made.bin"), resources);
  const io::WrittenFiles text = io::write(model, "out.gltf");
  REQUIRE(text.files.size() == 3);
  CHECK(text.files[2].name == "my image.png");
  REQUIRE(text.warnings.size() == 1);
  CHECK(text.warnings[0].message.find("absent.png") != std::string::npos);
  const Json images = treeOf(io::write(model, "out.glb").files[0])["images"];
  CHECK(images[0]["mimeType"] == "image/png");
  CHECK(images[0].contains("bufferView"));
  CHECK(images[1]["uri"] == "absent.png");
}

TEST_CASE("gltf: OBJ becomes glTF with a primitive per group and texture rows from the top") {
  const io::Model model = io::read(
      textFile("t.obj",
               "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0.25\nusemtl a\nf 1/1 2/1 3/1\nusemtl b\n"
               "f 1/1 3/1 4/1\n"));
  const File file = io::write(model, "out.glb").files[0];
  const TriangleMesh mesh = io::read(file).parts[0].mesh;
  CHECK(mesh.groups == std::vector<Index>{0, 1});
  CHECK(mesh.attributes[0].values[1] == 0.75F);
  const File back = io::write(io::read(file), "back.obj").files[0];
  CHECK(textOf(back).find("vt 0 0.25\n") != std::string::npos);
}

TEST_CASE("gltf: other formats get every instance where it stands, mirrored ones turned around") {
  GltfMaker maker;
  maker.addMesh({{{"attributes", {{"POSITION", maker.add(kSquarePositions, kFloat, "VEC3")}}},
                  {"indices", maker.add(kSquareIndices, kUShort, "SCALAR")}}});
  maker.show({{{"mesh", 0}, {"translation", {0, 0, 5}}}, {{"mesh", 0}, {"scale", {-1, 1, 1}}}});
  const TriangleMesh mesh =
      io::read(io::write(io::read(maker.glb()), "out.off").files[0]).parts[0].mesh;
  REQUIRE(mesh.triangleCount() == 4);
  CHECK(mesh.positions[0].z() == 5);
  for (std::size_t t = 0; t < 4; ++t) {
    const Vec3 &a = mesh.positions[mesh.indices[3 * t]],
               &b = mesh.positions[mesh.indices[3 * t + 1]],
               &c = mesh.positions[mesh.indices[3 * t + 2]];
    CHECK((b - a).cross(c - a).z() == doctest::Approx(1));
  }
}

TEST_CASE("gltf: names become names in OBJ, whatever they hold") {
  GltfMaker maker;
  maker.addMesh({{{"attributes", {{"POSITION", maker.add(kSquarePositions, kFloat, "VEC3")}}},
                  {"indices", maker.add(kSquareIndices, kUShort, "SCALAR")},
                  {"material", 0}}});
  maker.tree["meshes"][0]["name"] = "a\nmtllib elsewhere.mtl";
  maker.tree["materials"] = Json::array({{{"name", "b\r\nf 1 2 3"}}});
  maker.show({{{"mesh", 0}}});
  const std::string text = textOf(io::write(io::read(maker.glb()), "out.obj").files[0]);
  CHECK(text.find("\nmtllib") == std::string::npos);
  CHECK(text.find('\r') == std::string::npos);
  CHECK(io::read(textFile("out.obj", text)).parts[0].mesh.triangleCount() == 2);
}

TEST_CASE("gltf: normals of a mesh shown flat or huge stay finite") {
  for (const double size : {0.0, 1e-200, 1e200}) {
    GltfMaker maker;
    maker.addMesh({{{"attributes",
                     {{"POSITION", maker.add(kSquarePositions, kFloat, "VEC3")},
                      {"NORMAL", maker.add(std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1},
                                           kFloat, "VEC3")}}},
                    {"indices", maker.add(kSquareIndices, kUShort, "SCALAR")}}});
    maker.show({{{"mesh", 0}, {"scale", {size, size, size}}}});
    const io::Model model = io::read(io::write(io::read(maker.glb()), "out.obj").files[0]);
    for (const float value : model.parts[0].mesh.attributes[0].values) CHECK(std::isfinite(value));
    CHECK(model.parts[0].mesh.attributes[0].values[2] == 1.0F);
  }
}
