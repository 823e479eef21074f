// SPDX-License-Identifier: MIT
#include "io/named/gmsh.h"

#include <doctest/doctest.h>

#include "io/files.h"

using namespace remesher;
using namespace remesher::test;

namespace {

// A tetrahedron whose base is of another material than its sides.
constexpr std::string_view kBaseAndSides =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0.1\nusemtl base\nf 1 3 2\nusemtl side\nf 1 2 4\nf 2 3 4\n"
    "f 3 1 4\n";

constexpr std::string_view kVersion2 =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n2 7 \"in let\"\n$EndPhysicalNames\n"
    "$Comments\nnothing\n$EndComments\n$Nodes\n5\n10 0 0 0\n20 1 0 0\n30 1 1 0\n40 0 1 0\n"
    "50 0 0 1\n$EndNodes\n$Elements\n4\n1 15 2 1 1 10\n2 3 2 7 1 10 20 30 40\n"
    "3 2 2 7 1 10 20 50\n4 4 2 9 1 10 20 30 50\n$EndElements\n";

std::vector<std::string> namesOf(const io::Part& part) {
  std::vector<std::string> names;
  for (const io::GroupInfo& group : part.groups) names.push_back(group.material);
  return names;
}

}  // namespace

TEST_CASE("gmsh: an OBJ's materials are physical groups, and come back") {
  const io::Model model = io::read(textFile("a.obj", kBaseAndSides));
  const File written = io::write(model, "o.msh").files[0];
  const io::Model again = io::read({"o.msh", written.bytes});
  REQUIRE(again.parts.size() == 1);
  CHECK(namesOf(again.parts[0]) == std::vector<std::string>{"base", "side"});
  CHECK(again.parts[0].mesh.positions == model.parts[0].mesh.positions);
  CHECK(again.parts[0].mesh.indices == model.parts[0].mesh.indices);
  CHECK(again.parts[0].mesh.groups == std::vector<Index>{0, 1, 1, 1});
  CHECK(textOf(io::write(again, "o.msh").files[0]) == textOf(written));
}

TEST_CASE("gmsh: parts that share places share nodes, if the model says so") {
  io::Model model = io::read(textFile("a.obj", kBaseAndSides));
  model.source = nullptr;
  model.parts.push_back(model.parts.front());
  for (Vec3& p : model.parts.back().mesh.positions) p.z() = -p.z();
  const auto nodes = [&] {
    return io::read({"o.msh", io::write(model, "o.msh").files[0].bytes})
        .parts[0]
        .mesh.positions.size();
  };
  CHECK(nodes() == 8);
  model.sharesNodes = true;
  CHECK(nodes() == 5);
}

TEST_CASE("gmsh: quads stay quads") {
  const io::Model model = io::read(textFile("q.obj",
                                            "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\n"
                                            "f 1 2 3 4\nf 2 5 6 3\n"));
  const io::Model again = io::read({"q.msh", io::write(model, "q.msh").files[0].bytes});
  CHECK(again.parts[0].mesh.isQuads);
  CHECK(again.parts[0].mesh.triangleCount() == 4);
}

TEST_CASE(
    "gmsh: version 2 is read, numbers with gaps, names with blanks; tetrahedra are left out") {
  const io::Model model = io::read(textFile("v2.msh", kVersion2));
  CHECK(model.parts[0].mesh.triangleCount() == 3);
  CHECK(namesOf(model.parts[0]) == std::vector<std::string>{"in let"});
  REQUIRE(model.warnings.size() == 1);
  CHECK(model.warnings[0].code == "ELEMENTS_LEFT_OUT");
  CHECK(model.warnings[0].count == 1);
}

TEST_CASE("gmsh: bad files are refused with the line and what is wrong") {
  const auto check = [](std::string text, const std::string& from, const std::string& to,
                        std::string_view part) {
    text.replace(text.find(from), from.size(), to);
    const std::string failure = readingFails(textFile("bad.msh", text));
    CAPTURE(failure);
    CHECK(failure.find(part) != std::string::npos);
  };
  const std::string text(kVersion2);
  check(text, "2.2 0", "2.2 1", "binary");
  check(text, "2.2 0", "3 0", "of version 3");
  check(text, "10 20 50", "10 21 50", "names node 21");
  check(text, "1 1 0\n", "1 nan 0\n", "not finite");
}
