// SPDX-License-Identifier: MIT
#include "io/text/off.h"

#include <doctest/doctest.h>

#include "io/files.h"

using namespace remesher;
using namespace remesher::test;

namespace {

constexpr std::string_view kTetrahedron =
    "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 0.1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

}  // namespace

TEST_CASE("off: a file read and written is the same file") {
  const io::Model model = io::read(textFile("t.off", kTetrahedron));
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
  check("NOFF\n1 0 0\n0 0 0\n0 0 -1e39\n",
        "NON_FINITE bad.off, line 4: the coordinate of a normal");
  check("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "INDEX_OUT_OF_RANGE bad.off, line 6");
  check("OFF\n-3 1 0\n", "not a whole number");
  check("OFF BINARY\n", "not a number: \"BINARY\"");
  check("# nothing\n", "PARSE_ERROR");
  check("OFF\n1 0 0\n0 0 0\n", "NO_TRIANGLES bad.off has no faces");
}
