// SPDX-License-Identifier: MIT
#include "io/named/vtu.h"

#include <doctest/doctest.h>

#include <cstring>

#include "io/files.h"
#include "io/model/resources.h"

using namespace remesher;
using namespace remesher::test;

namespace {

// A square of two triangles and a strip over it, with arrays as `points` and `rest` write them.
std::string grid(const std::string& points, const std::string& attributes = "") {
  return "<?xml version=\"1.0\"?>\n<!-- by hand -->\n<VTKFile type=\"UnstructuredGrid\" " +
         attributes +
         ">\n<UnstructuredGrid><Piece NumberOfPoints=\"4\" NumberOfCells=\"3\">\n<Points>" +
         points +
         "</Points>\n<Cells>\n<DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">"
         "0 1 2 0 2 3 0 1 2 3</DataArray>\n<DataArray type=\"Int32\" Name=\"offsets\" "
         "format=\"ascii\">3 6 10</DataArray>\n<DataArray type=\"UInt8\" Name=\"types\" "
         "format=\"ascii\">5 5 10</DataArray>\n</Cells>\n</Piece></UnstructuredGrid>";
}

constexpr std::string_view kEnd = "</VTKFile>\n";

std::string array(const std::string& format, const std::string& inner) {
  return "<DataArray type=\"Float32\" NumberOfComponents=\"3\" " + format + ">" + inner +
         "</DataArray>";
}

std::vector<std::uint8_t> bytesWithLength(const std::vector<float>& numbers) {
  const auto length = static_cast<std::uint32_t>(4 * numbers.size());
  std::vector<std::uint8_t> bytes(4 + length);
  std::memcpy(bytes.data(), &length, 4);
  std::memcpy(bytes.data() + 4, numbers.data(), length);
  return bytes;
}

std::string base64(const std::vector<std::uint8_t>& bytes) {
  const std::string uri = io::encodeDataUri("", bytes);
  return uri.substr(uri.find(',') + 1);
}

const std::vector<float> kGridPoints = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0.5f};

void checkSquare(const std::string& text) {
  CAPTURE(text);
  const io::Model model = io::read(textFile("a.vtu", text));
  REQUIRE(model.parts.size() == 1);
  const TriangleMesh& mesh = model.parts[0].mesh;
  CHECK(mesh.indices == std::vector<Index>{0, 1, 2, 0, 2, 3});
  REQUIRE(mesh.positions.size() == 4);
  CHECK(mesh.positions[3] == Vec3(0, 1, 0.5));
  REQUIRE(model.warnings.size() == 1);  // of the tetrahedron
  CHECK(model.warnings[0].code == "ELEMENTS_LEFT_OUT");
}

}  // namespace

TEST_CASE("vtu: arrays as text, as base64 and appended say the same") {
  const std::vector<std::uint8_t> bytes = bytesWithLength(kGridPoints);
  checkSquare(grid(array("format=\"ascii\"", "0 0 0 1 0 0\n1 1 0 0 1 .5")) + std::string(kEnd));
  checkSquare(grid(array("format=\"binary\"", "\n  " + base64(bytes) + "\n")) + std::string(kEnd));
  const std::string appended = grid(array("format=\"appended\" offset=\"0\"", ""));
  checkSquare(appended + "<AppendedData encoding=\"base64\">\n_" + base64(bytes) +
              "</AppendedData>" + std::string(kEnd));
  checkSquare(appended + "<AppendedData encoding=\"raw\">_" +
              std::string(bytes.begin(), bytes.end()) + "</AppendedData>" + std::string(kEnd));
}

TEST_CASE("vtu: sets, their names and quads come back") {
  const io::Model model =
      io::read(textFile("a.obj",
                        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nusemtl wall <1>\n"
                        "f 1 2 3 4\nusemtl in & out\nf 2 5 6 3\n"));
  const File written = io::write(model, "o.vtu").files[0];
  const io::Model again = io::read({"o.vtu", written.bytes});
  REQUIRE(again.parts[0].groups.size() == 2);
  CHECK(again.parts[0].groups[1].material == "in & out");
  CHECK(again.parts[0].mesh.isQuads);
  CHECK(again.parts[0].mesh.groups == std::vector<Index>{0, 0, 1, 1});
  CHECK(textOf(io::write(again, "o.vtu").files[0]) == textOf(written));
}

TEST_CASE("vtu: files that cannot be read are refused with the reason") {
  const auto fails = [](const std::string& text) { return readingFails(textFile("a.vtu", text)); };
  const std::string square = array("format=\"ascii\"", "0 0 0 1 0 0 1 1 0 0 1 0");
  CHECK(fails(grid(square, "compressor=\"vtkZLibDataCompressor\"")).find("compressed") !=
        std::string::npos);
  CHECK(fails(grid(square, "byte_order=\"BigEndian\"")).find("order of bytes") !=
        std::string::npos);
  CHECK(fails(grid(array("format=\"ascii\"", "0 0 0 1 0 0"))).find("INDEX_OUT_OF_RANGE") == 0);
  CHECK(fails(grid(array("format=\"appended\" offset=\"9\"", ""))).find("outside") !=
        std::string::npos);
}
