// SPDX-License-Identifier: MIT
#include "io/text/obj.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "io/files.h"

using namespace remesher;
using namespace remesher::test;

namespace {

// A square of two materials whose halves have different normals and share a texture.
constexpr std::string_view kTwoMaterials = R"(mtllib square.mtl
v 0 0 0
v 1 0 0
v 1 1 0.25
v 0 1 0
vt 0 0
vt 1 0
vt 1 1
vt 0 1
vn 0 0 1
vn 0 1 0
o sheet
g left
usemtl red
s 1
f 1/1/1 2/2/1 3/3/1
usemtl blue paint
s off
f 1/1/2 3/3/2 4/4/2
)";

TriangleMesh objMesh(std::string_view text) {
  const io::Model model = io::read(textFile("test.obj", text));
  REQUIRE(model.parts.size() == 1);
  return model.parts[0].mesh;
}

constexpr std::string_view kObjSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

std::string objSquare(std::string_view faces) {
  return std::string(kObjSquare) + std::string(faces);
}

}  // namespace

TEST_CASE("obj: every way of writing the same triangles reads as the same triangles") {
  const std::vector<Index> expected = {0, 1, 2, 0, 2, 3};
  for (const char* faces :
       {"f 1 2 3\nf 1 3 4\n", "f 1 2 3 4", "f -4 -3 -2 -1\n", "f 1 2 3 4 # a square\n",
        "f 1 2 \\\n 3 4\n", "f 1 2 \\\r\n 3 4\r\n", "\tf  1  2\t3  4  \n", "f 1/ 2/ 3/ 4/\n",
        "f 1// 2// 3// 4//\n", "vp 1 2\nf +1 2 3 4\n"}) {
    CAPTURE(faces);
    CHECK(objMesh(objSquare(faces)).indices == expected);
  }
}

TEST_CASE("obj: all three line endings and a byte order mark are read") {
  std::string carriageReturns = objSquare("f 1 2 3\n");
  for (char& c : carriageReturns)
    if (c == '\n') c = '\r';
  CHECK(objMesh(carriageReturns).positions.size() == 4);
  CHECK(objMesh("\xEF\xBB\xBF" + objSquare("f 1 2 3\n")).positions.size() == 4);
}

TEST_CASE("obj: a file without vt and vn keeps the numbers of its vertices") {
  const TriangleMesh mesh = objMesh("v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 4 2 3\n");
  CHECK(mesh.positions.size() == 4);
  CHECK(mesh.indices == std::vector<Index>{3, 1, 2});
  CHECK(mesh.attributes.empty());
}

TEST_CASE("obj: a vertex is made for each combination of position, texture coordinate and normal") {
  const TriangleMesh mesh = objMesh(kTwoMaterials);
  CHECK(mesh.positions.size() == 6);
  CHECK(mesh.groups == std::vector<Index>{0, 1});
  REQUIRE(mesh.attributes.size() == 2);
  CHECK(mesh.attributes[0].semantic == "NORMAL");
  CHECK(mesh.attributes[1].semantic == "TEXCOORD_0");
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK(mesh.attributes[1].values[2 * i] == mesh.positions[i].x());
    CHECK(mesh.attributes[1].values[2 * i + 1] == mesh.positions[i].y());
  }
}

TEST_CASE("obj: vertex colours are read and written") {
  const io::Model model =
      io::read(textFile("c.obj", "v 0 0 0 1 0 0.5\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nf 1 2 3\n"));
  REQUIRE(model.parts[0].mesh.attributes.size() == 1);
  CHECK(model.parts[0].mesh.attributes[0].semantic == "COLOR_0");
  const File written = io::write(model, "out.obj").files[0];
  CHECK(textOf(written) == "v 0 0 0 1 0 0.5\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nf 1 2 3\n");
}

TEST_CASE("obj: colours as bytes are those of fractions, and a vertex without one is white") {
  const auto colors = [](const std::string& first) {
    const io::Model model = io::read(textFile("c.obj", "v 0 0 0 " + first + "v 1 0 0\nf 1 3 2\n"));
    return model.parts[0].mesh.attributes.at(0).values;
  };
  const std::vector<float> bytes = colors("255 51 0\nv 0 1 0 0 102 255\n");
  CHECK(bytes == colors("1 0.2 0\nv 0 1 0 0 0.4 1\n"));
  CHECK(std::count(bytes.begin(), bytes.end(), 1.0F) == 5);
  CHECK(colors("1.5 0.25 0\nv 0 1 0 0 1 1\n").front() == 1.5F);
}

TEST_CASE("obj: groups, materials and the library come back") {
  const io::Model model = io::read(textFile("square.obj", kTwoMaterials),
                                   {textFile("square.mtl", "newmtl red\nnewmtl blue paint\n")});
  CHECK(model.warnings.empty());
  const io::WrittenFiles written = io::write(model, "out.obj");
  REQUIRE(written.files.size() == 2);
  CHECK(written.files[1].name == "square.mtl");
  CHECK(textOf(written.files[1]) == "newmtl red\nnewmtl blue paint\n");
  const std::string text = textOf(written.files[0]);
  for (const char* line : {"mtllib square.mtl\n", "o sheet\n", "g left\n", "usemtl red\n", "s 1\n",
                           "usemtl blue paint\n", "s off\n"}) {
    CAPTURE(line);
    CHECK(text.find(line) != std::string::npos);
  }
  const io::Model again = io::read(written.files[0]);
  CHECK(again.warnings.size() == 1);  // this time the library was not given
  const TriangleMesh &before = model.parts[0].mesh, &after = again.parts[0].mesh;
  CHECK(after.positions == before.positions);
  CHECK(after.indices == before.indices);
  CHECK(after.groups == before.groups);
  for (std::size_t i = 0; i < 2; ++i)
    CHECK(after.attributes[i].values == before.attributes[i].values);
}

TEST_CASE(
    "obj: what its library needs and nobody brings is said; a library from above is laid in") {
  const io::Model model =
      io::read(textFile("a.obj", "mtllib ../m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
               {textFile("../m.mtl", "newmtl red\nmap_Kd ../wood.png\n")});
  REQUIRE(model.warnings.size() == 1);
  CHECK(model.warnings[0].code == "MATERIAL_IMAGES_NOT_READ");
  CHECK(model.warnings[0].message.find("../wood.png") != std::string::npos);
  CHECK(model.warnings[0].message.find("--textures bake") != std::string::npos);
  const io::WrittenFiles written = io::write(model, "out.obj");
  CHECK(written.files.at(1).name == "m.mtl");
  CHECK(textOf(written.files[0]).find("mtllib m.mtl\n") == 0);
}

TEST_CASE("obj: mtllib has one name, with blanks if a file has that name, or several") {
  const File obj = textFile("a.obj", "mtllib a.mtl  b.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const auto libraries = [&](const std::vector<std::string>& given) {
    std::vector<File> files;
    for (const std::string& name : given) files.push_back(textFile(name, "newmtl red\n"));
    const io::Model model = io::read(obj, files);
    const std::string text = textOf(io::write(model, "b.obj").files.at(0));
    return std::pair(text.substr(0, text.find("v ")), model.warnings.size());
  };
  CHECK(libraries({"a.mtl", "b.mtl"}) ==
        std::pair(std::string("mtllib a.mtl\nmtllib b.mtl\n"), std::size_t{0}));
  CHECK(libraries({"b.mtl"}) ==
        std::pair(std::string("mtllib a.mtl\nmtllib b.mtl\n"), std::size_t{1}));
  CHECK(libraries({"a.mtl  b.mtl", "b.mtl"}) ==
        std::pair(std::string("mtllib a.mtl  b.mtl\n"), std::size_t{0}));
  CHECK(libraries({}) == std::pair(std::string("mtllib a.mtl  b.mtl\n"), std::size_t{1}));
}

TEST_CASE("obj, off: written exactly, floats are the same numbers to a reader of doubles") {
  io::Model model = io::read(textFile("test.obj", objSquare("f 1 2 3\nf 1 3 4\n")));
  TriangleMesh& mesh = model.parts[0].mesh;
  mesh.isSingle = true;
  for (Vec3& p : mesh.positions) p = Vec3(double(0.1F), double(1.0F / 3), 2.0) + p;
  for (Vec3& p : mesh.positions) p = inSingle(p, {});
  for (const char* const name : {"exact.obj", "exact.off"}) {
    const auto back = [&] {
      return io::read(io::write(model, name).files[0]).parts[0].mesh.positions;
    };
    model.isExact = false;
    CHECK(back() != mesh.positions);
    model.isExact = true;
    CHECK(back() == mesh.positions);
  }
}

TEST_CASE("obj, off: where any coordinate is no float, all have the digits of doubles") {
  TriangleMesh mesh = objMesh(objSquare("f 1 2 3 4"));
  mesh.positions[0].x() = 45938.46875;  // a float, whose fewest digits are 45938.47
  mesh.positions[1].y() = 45938.4778947830;
  io::Model model;
  model.parts = {{"", mesh, {Transform::Identity()}}};
  for (const char* name : {"a.obj", "a.off"}) {
    CAPTURE(name);
    const File file = io::write(model, name).files.front();
    CHECK(asText(file).find("45938.46875 ") != std::string_view::npos);
  }
}

TEST_CASE("obj: vertices that differ in attributes only share a v") {
  const std::string text =
      textOf(io::write(io::read(textFile("t.obj", kTwoMaterials)), "o.obj").files[0]);
  std::size_t count = 0;
  for (std::size_t at = text.find("\nv "); at != std::string::npos; at = text.find("\nv ", at + 1))
    ++count;
  CHECK(count == 4);
}

TEST_CASE("obj: attributes that a remeshed part lost are left out") {
  io::Model model = io::read(textFile("t.obj", kTwoMaterials));
  model.parts[0].mesh.attributes.clear();
  CHECK(textOf(io::write(model, "o.obj").files[0]).find("f 1 2 ") != std::string::npos);
}

TEST_CASE("obj: bad files are refused with the line and what is wrong") {
  const auto failure = [](const std::string& text) {
    return readingFails(textFile("bad.obj", text));
  };
  const auto contains = [](const std::string& text, std::string_view part) {
    CAPTURE(text);
    CHECK(text.find(part) != std::string::npos);
  };
  contains(failure(""), "EMPTY_FILE bad.obj");
  contains(failure("v 0 0 nan\n"), "NON_FINITE bad.obj, line 1");
  contains(failure("v 0 0 1e999\n"), "NON_FINITE bad.obj, line 1");
  contains(failure("v 0 0\n"), "PARSE_ERROR bad.obj, line 1");
  contains(failure("v 0 0 x\n"), "not a number: \"x\"");
  contains(failure("\nv 0 0 0\nf 1 2 3\n"), "INDEX_OUT_OF_RANGE bad.obj, line 3");
  contains(failure(objSquare("f 1 2 0\n")), "INDEX_OUT_OF_RANGE bad.obj, line 5");
  contains(failure(objSquare("f 1 2 -5\n")), "INDEX_OUT_OF_RANGE bad.obj, line 5");
  contains(failure(objSquare("f 1/1 2/1 3/1\n")), "texture coordinate 1, but there is none");
  contains(failure(objSquare("f 1 2\n")), "fewer than three corners");
  contains(failure(objSquare("f 1 b 3\n")), "PARSE_ERROR bad.obj, line 5");
  contains(failure(objSquare("f 1/2/3/4 2 3\n")), "INDEX_OUT_OF_RANGE");
}

TEST_CASE("obj: a file without faces is refused, lines beside faces are only counted") {
  CHECK(readingFails(textFile("points.obj", objSquare("p 1 2\nl 1 2 3\n"))).find("NO_TRIANGLES") ==
        0);
  const io::Model model = io::read(textFile("mixed.obj", objSquare("f 1 2 3\np 1 2\nl 1 2 3\n")));
  REQUIRE(model.warnings.size() == 1);
  CHECK(model.warnings[0].count == 2);
}

TEST_CASE("obj: attributes that are not finite are read as 0, which is said with the line") {
  const io::Model model = io::read(textFile("a.obj",
                                            "v 0 0 0 nan 1 0\nv 1 0 0 0 1 0\nv 0 1 0 0 1 0\n"
                                            "vn nan nan nan\nvn 0 0 1e39\nvt inf 0\n"
                                            "f 1/1/1 2/1/2 3/1/2\n"));
  REQUIRE(model.warnings.size() == 1);
  CHECK(model.warnings[0].code == "NON_FINITE_ATTRIBUTE");
  CHECK(model.warnings[0].count == 6);
  CHECK(model.warnings[0].message.find("the first in line 1.") != std::string::npos);
  for (const Attribute& attribute : model.parts.at(0).mesh.attributes)
    for (const float value : attribute.values) CHECK(std::isfinite(value));
}
