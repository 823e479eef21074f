// SPDX-License-Identifier: MIT
#include "io/ply/ply.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cstring>

#include "io/files.h"

using namespace remesher;
using namespace remesher::test;

namespace {

// The body of a binary file in the making.
struct BinaryBody {
  bool isBigEndian = false;
  std::string bytes = {};

  template <class Number>
  BinaryBody& put(Number value) {
    std::string raw(sizeof value, '\0');
    std::memcpy(raw.data(), &value, sizeof value);
    if (isBigEndian) std::reverse(raw.begin(), raw.end());
    bytes += raw;
    return *this;
  }
};

const std::string kVertices =
    "property double x\nproperty float y\nproperty short z\nproperty uchar red\n"
    "property uchar green\nproperty uchar blue\nproperty float quality\nproperty int label\n";

std::string headerOf(const std::string& format) {
  return "ply\nformat " + format + " 1.0\ncomment made by hand\nobj_info num_cols 7\n" +
         "element vertex 4\n" + kVertices + "element face 2\n" +
         "property list uchar int vertex_indices\nend_header\n";
}

std::string textSquare() {
  return headerOf("ascii") +
         "0 0.1 0 255 0 9 0.5 1\n1 0.1 0 255 0 9 0.25 2\n1 1.5 -7 255 0 9 0.125 3\n"
         "0.30000000000000004 1 0 255 0 9 0.1 4\n3 0 1 2\n3 0 2 3\n";
}

std::string binarySquare(bool isBigEndian) {
  BinaryBody body{isBigEndian};
  const double x[] = {0, 1, 1, 0.30000000000000004};
  const float y[] = {0.1F, 0.1F, 1.5F, 1};
  const float quality[] = {0.5F, 0.25F, 0.125F, 0.1F};
  for (std::int32_t i = 0; i < 4; ++i)
    body.put(x[i])
        .put(y[i])
        .put(std::int16_t(i == 2 ? -7 : 0))
        .put(std::uint8_t{255})
        .put(std::uint8_t{0})
        .put(std::uint8_t{9})
        .put(quality[i])
        .put(i + 1);
  for (const std::int32_t middle : {1, 2})
    body.put(std::uint8_t{3}).put(std::int32_t{0}).put(middle).put(middle + 1);
  return headerOf(isBigEndian ? "binary_big_endian" : "binary_little_endian") + body.bytes;
}

const std::string kTriangle =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_index\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  REQUIRE(at != std::string::npos);
  return text.replace(at, what.size(), by);
}

TriangleMesh plyMesh(const std::string& bytes) {
  return io::read(textFile("a.ply", bytes)).parts.at(0).mesh;
}

std::vector<float> attributeOf(const TriangleMesh& mesh, const std::string& semantic) {
  const Attribute* const attribute = findAttribute(mesh, semantic);
  REQUIRE(attribute != nullptr);
  return attribute->values;
}

// Read, with a mesh that says the same in place of the one read, and written.
std::string rewritten(const std::string& bytes) {
  io::Model model = io::read(textFile("a.ply", bytes));
  TriangleMesh& mesh = model.parts[0].mesh;
  mesh.indices.insert(mesh.indices.end(), mesh.indices.begin(), mesh.indices.begin() + 3);
  const std::string once = textOf(io::write(model, "b.ply").files[0]);
  return once;
}

}  // namespace

TEST_CASE("ply: text and both orders of bytes say the same") {
  const TriangleMesh text = plyMesh(textSquare());
  CHECK(text.indices == std::vector<Index>{0, 1, 2, 0, 2, 3});
  CHECK(text.positions[3].x() == 0.30000000000000004);
  CHECK(text.positions[2].z() == -7);
  CHECK(attributeOf(text, "COLOR_0")[0] == 1);
  CHECK(attributeOf(text, "COLOR_0")[2] == 9.0F / 255);
  CHECK(attributeOf(text, "_QUALITY") == std::vector<float>{0.5F, 0.25F, 0.125F, 0.1F});
  CHECK(attributeOf(text, "_LABEL") == std::vector<float>{1, 2, 3, 4});
  for (const bool isBigEndian : {false, true}) {
    const TriangleMesh binary = plyMesh(binarySquare(isBigEndian));
    CHECK(binary.indices == text.indices);
    CHECK(binary.positions[0].y() == double{0.1F});
    CHECK(binary.positions == text.positions);
    for (std::size_t a = 0; a < text.attributes.size(); ++a)
      CHECK(binary.attributes[a].values == text.attributes[a].values);
  }
}

TEST_CASE("ply: a file read and written is the same file, bit for bit") {
  for (const std::string& bytes : {textSquare(), binarySquare(false), binarySquare(true)})
    CHECK(textOf(io::write(io::read(textFile("a.ply", bytes)), "b.ply").files[0]) == bytes);
}

TEST_CASE("ply: a new mesh is written in the encoding and the types of the file") {
  for (const std::string& bytes : {textSquare(), binarySquare(false), binarySquare(true)}) {
    const std::string twoTriangles = "element face 2";
    const std::string expected = replaced(bytes, twoTriangles, "element face 3");
    const std::string written = rewritten(bytes);
    CHECK(written.substr(0, expected.size()) == expected);
    CHECK(plyMesh(written).indices == std::vector<Index>{0, 1, 2, 0, 2, 3, 0, 1, 2});
  }
}

TEST_CASE("ply: integers of a new mesh are rounded, and stay in their range") {
  io::Model model = io::read(textFile("a.ply", binarySquare(false)));
  for (Attribute& attribute : model.parts[0].mesh.attributes) {
    if (attribute.semantic == "_LABEL") attribute.values[0] = 6.6F;
    if (attribute.semantic == "COLOR_0")
      attribute.values = {2, -1, 0.5F, 1, 1, 1, 1, 1, 1, 1, 1, 1};
  }
  const TriangleMesh mesh = plyMesh(textOf(io::write(model, "b.ply").files[0]));
  CHECK(attributeOf(mesh, "_LABEL")[0] == 7);
  CHECK(attributeOf(mesh, "COLOR_0")[0] == 1);
  CHECK(attributeOf(mesh, "COLOR_0")[1] == 0);
  CHECK(attributeOf(mesh, "COLOR_0")[2] == 128.0F / 255);
}

TEST_CASE("ply: polygons and strips become triangles") {
  const std::string quad =
      replaced(replaced(kTriangle, "vertex 3", "vertex 4"), "3 0 1 2", "1 1 0\n4 0 1 3 2");
  CHECK(plyMesh(quad).indices == std::vector<Index>{0, 1, 3, 0, 3, 2});
  const std::string strips = replaced(
      replaced(replaced(quad, "element face 1", "element tristrips 1"), "uchar int", "int int"),
      "4 0 1 3 2", "8 0 1 2 3 -1 3 2 1");
  CHECK(plyMesh(strips).indices == std::vector<Index>{0, 1, 2, 2, 1, 3, 3, 2, 1});
}

TEST_CASE("ply: elements in any order, unknown ones and lists of vertices are passed over") {
  const std::string text =
      "ply\r\nformat ascii 1.0\r\nelement camera 1\r\nproperty float view_px\r\n"
      "element face 1\r\nproperty uchar flags\r\nproperty list uchar uint vertex_indices\r\n"
      "element nothing 4000000000\r\nelement vertex 3\r\nproperty float x\r\n"
      "property list uchar float weights\r\nproperty float y\r\nproperty float z\r\n"
      "element edge 1\r\nproperty int vertex1\r\nproperty int vertex2\r\nend_header\r\n"
      "7\r\n0 3 2 1 0\r\n0 2 8 8 0 0\r\n1 0 0 0\r\n0 1 5 1 0\r\n0 1\r\n";
  const io::Model model = io::read(textFile("a.ply", text));
  CHECK(model.parts[0].mesh.indices == std::vector<Index>{2, 1, 0});
  CHECK(model.parts[0].mesh.positions[2] == Vec3(0, 1, 0));
  std::string warnings;
  for (const Warning& warning : model.warnings) warnings += warning.message;
  for (const char* lost : {"weights", "flags", "camera", "edge"})
    CHECK(warnings.find(lost) != std::string::npos);
}

TEST_CASE("ply: a header of lone carriage returns ends before a body that begins with a newline") {
  BinaryBody body;
  std::string header = replaced(kTriangle, "ascii", "binary_little_endian");
  header = header.substr(0, header.find("0 0 0"));
  std::replace(header.begin(), header.end(), '\n', '\r');
  body.put(std::bit_cast<float>(0x3F80000AU)).put(0.0F).put(0.0F);
  body.put(1.0F).put(0.0F).put(0.0F).put(0.0F).put(1.0F).put(0.0F);
  body.put(std::uint8_t{3}).put(0).put(1).put(2);
  CHECK(plyMesh(header + body.bytes).positions[0].x() == double{std::bit_cast<float>(0x3F80000AU)});
}

TEST_CASE("ply: normals, texture coordinates and colours go by all their names") {
  const auto semanticsWith = [](const std::string& names) {
    std::string properties, zeros, at = names + " ";
    for (std::size_t end; (end = at.find(' ')) != std::string::npos; at.erase(0, end + 1)) {
      properties += "property float " + at.substr(0, end) + "\n";
      zeros += " 0";
    }
    const std::string text =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\n" +
        properties +
        "element face 1\n"
        "property list uchar int vertex_indices\nend_header\n0 0 0" +
        zeros + "\n1 0 0" + zeros + "\n0 1 0" + zeros + "\n3 0 1 2\n";
    std::string semantics;
    for (const Attribute& attribute : plyMesh(text).attributes)
      semantics += attribute.semantic + std::to_string(attribute.itemSize) + " ";
    return semantics;
  };
  CHECK(semanticsWith("nx ny nz") == "NORMAL3 ");
  for (const char* names : {"s t", "u v", "texture_u texture_v"})
    CHECK(semanticsWith(names) == "TEXCOORD_02 ");
  for (const char* names : {"red green blue", "diffuse_red diffuse_green diffuse_blue", "r g b"})
    CHECK(semanticsWith(names) == "COLOR_03 ");
  CHECK(semanticsWith("red green blue alpha") == "COLOR_04 ");
  CHECK(semanticsWith("nx ny") == "_NX1 _NY1 ");
  CHECK(semanticsWith("s t u") == "TEXCOORD_02 _U1 ");
  CHECK(semanticsWith("quality QUALITY Quality") == "_QUALITY1 __QUALITY1 _Quality1 ");
}

TEST_CASE("ply: attributes return from glTF under their own names") {
  const io::Model model = io::read(textFile("a.ply", binarySquare(false)));
  const io::Model gltf = io::read(io::write(model, "a.glb").files[0]);
  const std::string back = textOf(io::write(gltf, "b.ply").files[0]);
  for (const char* line : {"property uchar red\n", "property float quality\n",
                           "property float label\n", "format binary_little_endian"})
    CHECK(back.find(line) != std::string::npos);
  for (const char* semantic : {"COLOR_0", "_QUALITY", "_LABEL"})
    CHECK(attributeOf(plyMesh(back), semantic) == attributeOf(model.parts[0].mesh, semantic));
}

TEST_CASE("ply: coordinates far from the origin are written as doubles") {
  const auto typeOfX = [](const std::string& obj) {
    const std::string ply = textOf(io::write(io::read(textFile("a.obj", obj)), "a.ply").files[0]);
    return ply.substr(ply.find("property ") + 9, 6);
  };
  CHECK(typeOfX("v 0.1 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n") == "float ");
  CHECK(typeOfX("v 600000.1 0 0\nv 600001 0 0\nv 600000 1 0\nf 1 2 3\n") == "double");
  CHECK(typeOfX("v 1e39 0 0\nv 0 1e39 0\nv 0 0 1e39\nf 1 2 3\n") == "double");
}

TEST_CASE("ply: texture coordinates of corners part vertices, and come back to corners") {
  const std::string text =
      "ply\nformat ascii 1.0\ncomment TextureFile a.png\ncomment TextureFile b.png\n"
      "element vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 2\n"
      "property list uchar int vertex_indices\nproperty list uchar float texcoord\n"
      "property int texnumber\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
      "3 0 1 2 6 0 0 1 0 1 1 0\n3 0 2 3 6 0 0 0.5 1 0 1 1\n";
  io::Model model = io::read(textFile("a.ply", text));
  TriangleMesh& mesh = model.parts[0].mesh;
  CHECK(mesh.positions.size() == 5);  // only the corner at 1 1 has two
  CHECK(mesh.groups == std::vector<Index>{0, 1});
  CHECK(model.parts[0].groups[1].material == "b.png");
  std::swap(mesh.indices[0], mesh.indices[1]);
  std::swap(mesh.indices[1], mesh.indices[2]);
  const std::string turned = replaced(text, "3 0 1 2 6 0 0 1 0 1 1 0", "3 1 2 0 6 1 0 1 1 0 0 0");
  CHECK(textOf(io::write(model, "b.ply").files[0]) == turned);
}

TEST_CASE("ply: texture coordinates of corners that are no numbers are 0") {
  const std::string text = replaced(replaced(kTriangle, "vertex_index\n",
                                             "vertex_index\nproperty list uchar double texcoord\n"
                                             "property float texnumber\n"),
                                    "3 0 1 2\n", "3 0 1 2 6 nan 1 1e300 1 0.5 -inf nan\n");
  CHECK(attributeOf(plyMesh(text), "TEXCOORD_0") == std::vector<float>{0, 1, 0, 1, 0.5F, 0});
  const io::Model model = io::read(textFile("a.ply", text));
  REQUIRE(model.warnings.size() == 1);
  CHECK(model.warnings[0].code == "NON_FINITE_ATTRIBUTE");
  CHECK(model.warnings[0].count == 4);
  CHECK(textOf(io::write(model, "b.ply").files[0]).find(" 0 1 0 1 0.5 0 0\n") != std::string::npos);
}

TEST_CASE("ply: colours in floats may count to one or to 255") {
  const std::string colored = replaced(
      replaced(kTriangle, "property float z\n",
               "property float z\nproperty float red\nproperty float green\nproperty float blue\n"),
      "0 0 0\n1 0 0\n0 1 0\n", "0 0 0 51 0 0\n1 0 0 255 0 0\n0 1 0 0 0 102\n");
  CHECK(attributeOf(plyMesh(colored), "COLOR_0")[0] == 0.2F);
  CHECK(rewritten(colored).find("\n0 0 0 51 0 0\n") != std::string::npos);
}

TEST_CASE("ply: numbers that are not finite are refused of places, and 0 of the rest") {
  CHECK(readingFails(textFile("a.ply", replaced(kTriangle, "0 1 0\n", "0 nan 0\n")))
            .find("NON_FINITE a.ply, line 12: the y of vertex 2") == 0);
  const io::Model model = io::read(textFile("a.ply", replaced(textSquare(), "0.25", "nan")));
  CHECK(attributeOf(model.parts[0].mesh, "_QUALITY")[1] == 0);
  CHECK(model.warnings.at(0).code == "NON_FINITE_ATTRIBUTE");
  CHECK(textOf(io::write(model, "b.ply").files[0]).find("nan") == std::string::npos);
}

// Blender 2.47 wrote it so.
TEST_CASE("ply: an exporter's signature above the elements is a comment, below them an error") {
  const std::string signature = "Created by a program\n";
  const std::string above = replaced(kTriangle, "element vertex", signature + "element vertex");
  CHECK(plyMesh(above).positions == plyMesh(kTriangle).positions);
  CHECK_THROWS_AS(plyMesh(replaced(kTriangle, "element face", signature + "element face")), Error);
}

TEST_CASE("ply: a header of thousands of names is refused, not compared with itself") {
  std::string elements;
  std::string properties;
  for (int i = 0; i < 1001; ++i) {
    elements += "element e" + std::to_string(i) + " 0\n";
    properties += "property float p" + std::to_string(i) + "\n";
  }
  for (const std::string& many : {elements, properties})
    CHECK(
        readingFails(textFile("a.ply", replaced(kTriangle, "element face", many + "element face")))
            .find("UNSUPPORTED a.ply, line 1") == 0);
}

TEST_CASE("ply: bad files are refused with the place and what is wrong") {
  const auto check = [](const std::string& text, std::string_view part) {
    const std::string failure = readingFails(textFile("bad.ply", text));
    CAPTURE(failure);
    CHECK(failure.find(part) != std::string::npos);
  };
  const auto with = [](const std::string& what, const std::string& by) {
    return replaced(kTriangle, what, by);
  };
  check("PLY\n", "PARSE_ERROR bad.ply, line 1: the file does not begin with ply");
  check("ply\nformat ascii 1.0\n", "no end_header");
  check(with("ascii", "utf8"), "bad.ply, line 2: a PLY's format is");
  check(with("format ascii 1.0\n", ""), "says no format");
  check(with("float x", "flout x"), "line 4: \"flout\" is no type");
  check(with("float y", "float x"), "second property \"x\"");
  check(with("element face", "element vertex"), "second element \"vertex\"");
  check(with("property float x\n", ""), "no x, y and z");
  check(with("vertex_index", "corners"), "not one list vertex_indices");
  check(with("vertex 3", "vertex -3"), "not a whole number from 0");
  check(with("vertex 3", "vertex 4294967295"), "not a whole number from 0");
  check(with("vertex 3", "vertex 4294967294"), "the header promises 4294967294 of the element");
  check(with("face 1", "face 2"), "the file ends where the number of corners");
  check(with("face 1", "face 100"), "the header promises 100");
  check(with("0 1 0\n3", "0 one 0\n3"), "line 12: y is not a number: \"one\"");
  check(with("3 0 1 2", "3 0 1 3"), "INDEX_OUT_OF_RANGE bad.ply, line 13: a face names vertex 3");
  check(with("3 0 1 2", "3 0 1 -1"), "a face names vertex -1");
  check(with("3 0 1 2", "3 0 1 1.5"), "a face names vertex 1.5");
  check(with("3 0 1 2", "-3 0 1 2"), "not a whole number from 0");
  check(with("3 0 1 2", "4000000000 0 1 2"), "beyond the file's end");
  check(with("3 0 1 2", "2 0 1"), "NO_TRIANGLES bad.ply has no faces");
  check(replaced(with("face 1", "face 0"), "3 0 1 2\n", ""), "NO_TRIANGLES");
  const std::string binary = binarySquare(false);
  for (std::size_t length = binary.find("end_header") + 11; length < binary.size(); ++length)
    check(binary.substr(0, length), "PARSE_ERROR bad.ply, byte");
}
