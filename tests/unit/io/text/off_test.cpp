// SPDX-License-Identifier: MIT
#include "io/text/off.h"

#include <doctest/doctest.h>

#include "io/files.h"

using namespace remesher;
using namespace remesher::test;

namespace {

constexpr std::string_view kOffTetrahedron =
    "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 0.1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

}  // namespace

TEST_CASE("off: a file read and written is the same file") {
  const io::Model model = io::read(textFile("t.off", kOffTetrahedron));
  CHECK(textOf(io::write(model, "o.off").files[0]) ==
        "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 0.1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
}

TEST_CASE("off: comments, counts on the first line, polygons and face colours are read") {
  const io::Model model = io::read(textFile(
      "q.off",
      "# a square\nOFF 4 1 4 # counts\n\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3 255 0 0\n"));
  CHECK(model.parts[0].mesh.indices == std::vector<Index>{0, 1, 2, 0, 2, 3});
}

TEST_CASE("off: that colours of faces are lost is said") {
  const std::string points = "OFF\n4 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  CHECK(
      io::read(textFile("a.off", points + "3 0 1 2 # none\n3 0 2 3\n3 0 1 3\n")).warnings.empty());
  const io::Model model =
      io::read(textFile("a.off", points + "3 0 1 2 255 0 0\n3 0 2 3\n3 0 1 3 7\n"));
  REQUIRE(model.warnings.size() == 1);
  CHECK(model.warnings[0].code == "ATTRIBUTE_NOT_CARRIED");
  CHECK(model.warnings[0].message == "The colours of faces are not carried.");
  CHECK(model.warnings[0].count == 2);
}

TEST_CASE("off: normals, colours and texture coordinates are kept") {
  const std::string text =
      "STCNOFF\n3 1 0\n0 0 0 0 0 1 1 0 0 1 0.25 0.5\n1 0 0 0 0 1 1 0 0 1 0.5 0.5\n"
      "0 1 0 0 0 1 1 0 0 1 0.75 0.5\n3 0 1 2\n";
  CHECK(textOf(io::write(io::read(textFile("a.off", text)), "o.off").files[0]) == text);
}

TEST_CASE("off: numbers that need all the digits of a double keep them") {
  const std::string text =
      "OFF\n3 1 0\n-1315.353796 0.1 1e-300\n0.30000000000000004 1 0\n0 1 0\n3 0 1 2\n";
  CHECK(textOf(io::write(io::read(textFile("a.off", text)), "o.off").files[0]) == text);
}

TEST_CASE("off: bad files are refused with the line and what is wrong") {
  const auto check = [](const std::string& text, std::string_view part) {
    const std::string failure = readingFails(textFile("bad.off", text));
    CAPTURE(failure);
    CHECK(failure.find(part) != std::string::npos);
  };
  check("PLY\n", "PARSE_ERROR bad.off, line 1");
  check("OFF\n3 1 0\n0 0 0\n1 0 0\n", "the file ends where");
  check("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 inf\n3 0 1 2\n", "NON_FINITE bad.off, line 5");
  check("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "INDEX_OUT_OF_RANGE bad.off, line 6");
  check("OFF\n-3 1 0\n", "not a whole number");
  check("OFF BINARY\n", "UNSUPPORTED bad.off, line 1: the file is binary OFF");
  check("nOFF\n4\n1 0 0\n", "UNSUPPORTED bad.off, line 2: its vertices have 4 dimensions");
  check("4OFF\n1 0 0\n1 2 3 0\n", "NON_FINITE bad.off, line 3: a vertex is infinitely far");
  check("CCOFF\n", "does not begin with OFF");
  check("# nothing\n", "PARSE_ERROR");
  check("OFF\n1 0 0\n0 0 0\n", "NO_TRIANGLES bad.off has no faces");
}

namespace {

const TriangleMesh& meshOf(const io::Model& model) { return model.parts[0].mesh; }

std::vector<float> valuesOf(const io::Model& model, std::string_view semantic) {
  const Attribute* const attribute = findAttribute(meshOf(model), semantic);
  return attribute == nullptr ? std::vector<float>{} : attribute->values;
}

// Three vertices, what follows each in turn, and a face.
std::string withRows(const std::string& keyword, const std::string& rest) {
  return keyword + "\n3 1 0\n0 0 0" + rest + "\n1 0 0" + rest + "\n0 1 0" + rest + "\n3 0 1 2\n";
}

}  // namespace

TEST_CASE("off: colours are three numbers or four, bytes or fractions, said or not") {
  const std::vector<float> colors = {1, 0.2F, 0, 1, 1, 0.2F, 0, 1, 1, 0.2F, 0, 1};
  for (const char* rest : {" 255 51 0", " 255 51 0 255", " 1 0.2 0", " 1 0.2 0 1"})
    for (const char* keyword : {"COFF", "OFF"}) {
      const io::Model model = io::read(textFile("a.off", withRows(keyword, rest)));
      CHECK(valuesOf(model, "COLOR_0") == colors);
      CHECK(meshOf(model).indices == std::vector<Index>{0, 1, 2});
    }
}

TEST_CASE("off: several vertices in a line are no colours") {
  const io::Model model =
      io::read(textFile("a.off", "OFF\n4 2 0\n0 0 0 1 0 0\n1 1 0 0 1 0\n3 0 1 2\n3 0 2 3\n"));
  CHECK(valuesOf(model, "COLOR_0").empty());
  CHECK(meshOf(model).positions[1] == Vec3(1, 0, 0));
}

TEST_CASE("off: the letters of the keyword come in any order, and may be left out") {
  const std::string normal = " 0 0 1", color = " 255 51 0 255", texcoord = " 0.25 0.5";
  for (const char* keyword : {"STCNOFF", "CNSTOFF", "NSTCOFF", "NCSTOFF"}) {
    CAPTURE(keyword);
    const io::Model model =
        io::read(textFile("a.off", withRows(keyword, normal + color + texcoord)));
    CHECK(valuesOf(model, "NORMAL") == std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1});
    CHECK(valuesOf(model, "COLOR_0")[1] == 0.2F);
    CHECK(valuesOf(model, "TEXCOORD_0")[0] == 0.25F);
  }
  const io::Model bare = io::read(textFile("a.off", "3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"));
  CHECK(meshOf(bare).positions.size() == 3);
}

TEST_CASE("off: MeshLab's NC has colours before normals") {
  for (const char* color : {" 255 51 0 255", " 255 51 0"}) {
    const io::Model model =
        io::read(textFile("a.off", withRows("NCOFF", color + std::string(" 0 0.6 0.8"))));
    CHECK(valuesOf(model, "NORMAL")[2] == 0.8F);
    CHECK(valuesOf(model, "COLOR_0")[0] == 1);
    CHECK(valuesOf(model, "COLOR_0")[3] == 1);
  }
}

TEST_CASE("off: a fourth coordinate divides, and two dimensions lie in a plane") {
  const io::Model scaled =
      io::read(textFile("a.off", "4OFF\n3 1 0\n0 0 0 2\n2 0 4 2\n0 2 0 2\n3 0 1 2\n"));
  CHECK(meshOf(scaled).positions[1] == Vec3(1, 0, 2));
  const io::Model flat = io::read(textFile("a.off", "nOFF\n2\n3 1 0\n0 0\n1 0\n0 1\n3 0 1 2\n"));
  CHECK(meshOf(flat).positions[2] == Vec3(0, 1, 0));
  const io::Model both = io::read(
      textFile("a.off", "C4nOFF 3\n3 1 0\n0 0 0 1 9 9 9\n2 0 4 2 9 9 9\n0 1 0 1 9 9 9\n3 0 1 2\n"));
  CHECK(meshOf(both).positions[1] == Vec3(1, 0, 2));
  CHECK(valuesOf(both, "COLOR_0").size() == 12);
}

TEST_CASE("off: normals that are not finite are read as 0, which is said with the line") {
  const io::Model model = io::read(
      textFile("a.off", "NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 nan 0 -1e39\n0 1 0 0 0 1\n3 0 1 2\n"));
  REQUIRE(model.warnings.size() == 1);
  CHECK(model.warnings[0].code == "NON_FINITE_ATTRIBUTE");
  CHECK(model.warnings[0].count == 2);
  CHECK(model.warnings[0].message.find("the first in line 4.") != std::string::npos);
}
