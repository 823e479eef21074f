// SPDX-License-Identifier: MIT
#include "io/stl/stl.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstring>

#include "io/files.h"

using namespace remesher;
using namespace remesher::test;

namespace {

using Facet = std::array<float, 9>;

const std::vector<Facet> kTetrahedron = {{0, 0, 0, 0, 1, 0, 1, 0, 0},
                                         {0, 0, 0, 1, 0, 0, 0, 0, 1},
                                         {1, 0, 0, 0, 1, 0, 0, 0, 1},
                                         {0, 1, 0, 0, 0, 0, -0.0F, 0, 1}};

struct BinaryStl {
  std::string header = "made by hand";
  std::vector<Facet> facets = kTetrahedron;
  std::uint16_t color = 0;  // of the first facet

  std::string bytes() const {
    std::string result = header;
    result.resize(80, '\0');
    const auto append = [&](const void* data, std::size_t size) {
      result.append(static_cast<const char*>(data), size);
    };
    const auto count = static_cast<std::uint32_t>(facets.size());
    append(&count, 4);
    for (std::size_t i = 0; i < facets.size(); ++i) {
      const std::uint16_t word = i == 0 ? color : 0;
      result.append(12, '\0');  // a normal of zeros, as many write
      append(facets[i].data(), sizeof(Facet));
      append(&word, 2);
    }
    return result;
  }
};

std::string textFacet(const Facet& facet) {
  std::string text = "facet normal nan nan nan\n outer loop\n";
  for (std::size_t i = 0; i < 9; i += 3)
    text += "  vertex " + std::to_string(facet[i]) + " " + std::to_string(facet[i + 1]) + "\t" +
            std::to_string(facet[i + 2]) + "\n";
  return text + " endloop\nendfacet\n";
}

io::Model modelOf(const std::string& bytes) { return io::read(textFile("a.stl", bytes)); }

std::string written(const io::Model& model) { return textOf(io::write(model, "b.stl").files[0]); }

}  // namespace

TEST_CASE("stl: corners at one place are one vertex, and minus zero is zero") {
  const TriangleMesh mesh = modelOf(BinaryStl().bytes()).parts[0].mesh;
  CHECK(mesh.positions.size() == 4);
  CHECK(mesh.indices == std::vector<Index>{0, 1, 2, 0, 2, 3, 2, 1, 3, 1, 0, 3});
  CHECK(mesh.groups.empty());
}

TEST_CASE("stl: corners that differ in the last bit stay apart") {
  BinaryStl stl;
  stl.facets[1][3] = std::nextafter(1.0F, 2.0F);
  CHECK(modelOf(stl.bytes()).parts[0].mesh.positions.size() == 5);
}

TEST_CASE("stl: a binary file may begin with solid") {
  BinaryStl stl;
  stl.header = "solid but binary, facet normal and all";
  stl.header.resize(80, ' ');
  CHECK(modelOf(stl.bytes()).parts[0].mesh.triangleCount() == 4);
}

TEST_CASE("stl: the bytes of a binary file say how many facets it has, not their number") {
  std::string binary = BinaryStl().bytes();
  const io::Model more = modelOf(binary + "some more");
  CHECK(more.parts[0].mesh.triangleCount() == 4);
  CHECK(more.warnings.at(0).message.find("the last 9 are left out") != std::string::npos);
  for (const int count : {0, 1, 3}) {
    binary[80] = static_cast<char>(count);
    const io::Model model = modelOf(binary);
    CHECK(model.parts[0].mesh.triangleCount() == 4);
    CHECK(model.warnings.at(0).code == "COUNT_CONTRADICTS");
    CHECK(model.warnings.at(0).count == std::size_t(4 - count));
  }
}

TEST_CASE("stl: a text says what the binary does, in any case, with any line ends, with a mark") {
  std::string text = "  Solid cube # 1\r\n";
  for (const Facet& facet : kTetrahedron) text += textFacet(facet);
  text += "EndSolid cube\n";
  for (char& c : text)
    if (c == 'v') c = 'V';
  const TriangleMesh mesh = modelOf(text).parts[0].mesh;
  CHECK(mesh.indices == modelOf(BinaryStl().bytes()).parts[0].mesh.indices);
  CHECK(modelOf("\xEF\xBB\xBF" + text).parts[0].mesh.indices == mesh.indices);
  std::string inOneLine = text;
  for (std::size_t i = text.find('\n') + 1; i < inOneLine.size(); ++i)
    if (inOneLine[i] == '\n') inOneLine[i] = ' ';
  CHECK(modelOf(inOneLine).parts[0].mesh.indices == mesh.indices);
}

TEST_CASE("stl: solids are groups with names, welded to each other") {
  const std::string text = "solid inlet\n" + textFacet(kTetrahedron[0]) + "endsolid inlet\n" +
                           "solid wall\n" + textFacet(kTetrahedron[1]) +
                           textFacet(kTetrahedron[2]) + "endsolid\nsolid inlet\n" +
                           textFacet(kTetrahedron[3]) + "endsolid\n";
  const io::Model model = modelOf(text);
  CHECK(model.parts[0].mesh.positions.size() == 4);
  CHECK(model.parts[0].mesh.groups == std::vector<Index>{0, 1, 1, 0});
  CHECK(model.parts[0].groups[1].material == "wall");
  CHECK(io::write(model, "b.stl").warnings.at(0).code == "PARTS_MERGED");
}

TEST_CASE("stl: what is written has the same corners, normals that fit, and is read the same") {
  const std::string bytes = written(modelOf(BinaryStl().bytes()));
  REQUIRE(bytes.size() == 84 + 4 * 50);
  CHECK(bytes.find("remesher") < 80);
  CHECK(bytes.substr(0, 5) != "solid");
  for (std::size_t i = 0; i < 4; ++i) {
    std::array<float, 12> facet;
    std::memcpy(facet.data(), &bytes[84 + 50 * i], sizeof facet);
    for (std::size_t k = 0; k < 9; ++k) CHECK(facet[3 + k] == kTetrahedron[i][k]);
    const Vec3 normal(facet[0], facet[1], facet[2]);
    CHECK(normal.norm() == doctest::Approx(1));
    const auto corner = [&](std::size_t k) {
      return Vec3(facet[3 * k], facet[3 * k + 1], facet[3 * k + 2]);
    };
    CHECK((corner(2) - corner(1)).dot(normal) == doctest::Approx(0));
    CHECK((corner(2) - corner(1)).cross(corner(3) - corner(1)).dot(normal) > 0);
  }
  CHECK(written(modelOf(bytes)) == bytes);
}

TEST_CASE("stl: facets without area, tiny and huge ones have no normal that is not a number") {
  BinaryStl stl;
  stl.facets = {{0, 0, 0, 1, 1, 1, 2, 2, 2},
                {0, 0, 0, 1e-38F, 0, 0, 0, 1e-38F, 0},
                {0, 0, 0, 3e38F, 0, 0, 0, 3e38F, 0}};
  const std::string bytes = written(modelOf(stl.bytes()));
  for (std::size_t i = 0; i < 3; ++i) {
    std::array<float, 3> normal;
    std::memcpy(normal.data(), &bytes[84 + 50 * i], sizeof normal);
    CHECK(normal[2] == (i == 0 ? 0 : 1));
  }
}

TEST_CASE("stl: colours of both conventions are passed over with a warning") {
  BinaryStl stl;
  CHECK(modelOf(stl.bytes()).warnings.empty());
  stl.color = 0x8000 | 0x1F;  // VisCAM, SolidView: the highest bit says there is one
  CHECK(modelOf(stl.bytes()).warnings.at(0).count == 1);
  stl.header =
      std::string("COLOR=") + "\x01\x02\x03\xFF";  // Magics: the highest bit says there is none
  CHECK(modelOf(stl.bytes()).warnings.at(0).count == 3);
}

TEST_CASE("stl: bad files are refused with what is wrong") {
  const auto check = [](const std::string& bytes, std::string_view part) {
    const std::string failure = readingFails(textFile("bad.stl", bytes));
    CAPTURE(failure);
    CHECK(failure.find(part) != std::string::npos);
  };
  const std::string binary = BinaryStl().bytes();
  check("short", "PARSE_ERROR bad.stl: it is shorter than the header");
  check(binary.substr(0, 200), "promises 4 facets in 284 bytes, but has 200");
  std::string lying = binary;
  for (std::size_t i = 80; i < 84; ++i) lying[i] = '\xFF';
  check(lying, "promises 4294967295 facets in 214748364834 bytes, but has 284");
  check("solid " + binary.substr(6, 194), "promises 4 facets");
  BinaryStl stl;
  stl.facets[2][4] = std::nanf("");
  check(stl.bytes(), "NON_FINITE bad.stl: a corner of facet 2 is not finite");
  stl.facets.clear();
  check(stl.bytes(), "NO_TRIANGLES bad.stl has no facets");
  check("solid empty\nendsolid empty\n", "NO_TRIANGLES");
  check("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n", "within a facet");
  check("solid a\nouter loop\nvertex 0 0 0\nvertex 1 0", "ends within a vertex");
  check("solid a\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\n", "line 5: a facet has fewer");
  check("solid a\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\n", "more than three");
  check("solid a\nouter loop\nvertex 0 0 inf\n", "NON_FINITE bad.stl, line 3");
  check("solid a\nouter loop\nvertex 0 0 x\n", "not a number: \"x\"");
  check("solid a\nfacets\n", "an STL knows no \"facets\"");
}

TEST_CASE("stl: coordinates beyond single precision are refused") {
  const std::string obj = "v 1e39 0 0\nv 0 1e39 0\nv 0 0 1e39\nf 1 2 3\n";
  const io::Model model = io::read(textFile("a.obj", obj));
  CHECK(failureOf([&] { io::write(model, "b.stl"); }).find("too large for STL") !=
        std::string::npos);
}
