// SPDX-License-Identifier: MIT
#include "io/model/byte_reader.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>
#include <memory>

#include "io/files.h"

using namespace remesher;
using namespace remesher::test;

namespace {

template <class Number>
void put(std::string& bytes, Number value) {
  std::string raw(sizeof value, '\0');
  std::memcpy(raw.data(), &value, sizeof value);
  bytes += raw;
}

// A square in two triangles, then, if asked for, a face of four corners.
std::string binaryPly(bool hasPolygon, bool hasTextures) {
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property double z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
      "element face " +
      std::to_string(hasPolygon ? 4 : 2) + "\nproperty list uchar int vertex_indices\n" +
      (hasTextures ? "property list uchar float texcoord\nproperty int texnumber\n" : "") +
      "end_header\n";
  for (int i = 0; i < 4; ++i) {
    put(bytes, float(i % 2));
    put(bytes, float(i / 2));
    put(bytes, 0.1 * i);
    for (int k = 0; k < 3; ++k) put(bytes, std::uint8_t(60 * i + k));
  }
  std::vector<std::vector<int>> faces = {{0, 1, 3}, {0, 3, 2}};
  if (hasPolygon) faces.insert(faces.end(), {{0, 1, 3, 2}, {2, 1, 0}});
  for (const std::vector<int>& face : faces) {
    put(bytes, std::uint8_t(face.size()));
    for (const int corner : face) put(bytes, std::int32_t(corner));
    if (!hasTextures) continue;
    put(bytes, std::uint8_t(2 * face.size()));
    for (std::size_t i = 0; i < 2 * face.size(); ++i) put(bytes, float(face[i / 2]) + 0.5F);
    put(bytes, std::int32_t(face[0]));
  }
  return bytes;
}

std::string binaryStl(const std::string& header) {
  std::string bytes = header;
  bytes.resize(80, '\0');
  put(bytes, std::uint32_t{3});
  for (int facet = 0; facet < 3; ++facet) {
    bytes.append(12, '\0');
    for (int i = 0; i < 9; ++i) put(bytes, float((facet + i) % 4));
    put(bytes, std::uint16_t(facet == 1 ? 0x8000 : 0));
  }
  return bytes;
}

const std::string kText =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_index\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

// Two ends of lines, lines that go on, a comment that does not, and corners of two kinds.
const std::string kObj =
    "# by hand \\\nv 0 0 0\r\nv 1 \\\n0 0\nv 1 1 0\nv 0 1 \\\r\n0\nvt 0 0\nvt 1 0\nvt 1 1\n"
    "usemtl one\nf 1/1 2/2 3/3\nusemtl two\nf 1 3 4";

const std::string kPlainObj = "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0\nv 1 1 0\nf 1 2 4 3\n";

const std::string kOff = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

// The same as a GLB.
File glbOf(const File& file) { return io::write(io::read(file), "a.glb").files[0]; }

void checkSame(const File& outside, const File& inside) {
  const io::Model read = io::read(outside), wanted = io::read(inside);
  REQUIRE(read.parts.size() == wanted.parts.size());
  const TriangleMesh &mesh = read.parts[0].mesh, &model = wanted.parts[0].mesh;
  CHECK(mesh.positions == model.positions);
  CHECK(mesh.indices == model.indices);
  CHECK(mesh.groups == model.groups);
  CHECK(mesh.isSingle == model.isSingle);
  REQUIRE(mesh.attributes.size() == model.attributes.size());
  for (std::size_t a = 0; a < mesh.attributes.size(); ++a)
    CHECK(mesh.attributes[a].values == model.attributes[a].values);
  REQUIRE(read.warnings.size() == wanted.warnings.size());
  for (std::size_t w = 0; w < read.warnings.size(); ++w)
    CHECK(read.warnings[w].message == wanted.warnings[w].message);
  for (const char* const output : {"b.ply", "b.stl", "b.glb", "b.gltf"})
    CHECK(textOf(io::write(read, output).files[0]) == textOf(io::write(wanted, output).files[0]));
}

}  // namespace

TEST_CASE("byte reader: a file is read the same from blocks of any size") {
  for (const std::size_t block : {1, 7, 100, 1000}) {
    CAPTURE(block);
    for (const bool hasPolygon : {false, true})
      for (const bool hasTextures : {false, true}) {
        const std::string bytes = binaryPly(hasPolygon, hasTextures);
        checkSame(outside("a.ply", bytes, block), textFile("a.ply", bytes));
        const File glb = glbOf(textFile("a.ply", bytes));
        checkSame(outside("a.glb", textOf(glb), block), glb);
      }
    for (const char* const header : {"made by hand", "COLOR=", "solid in spite of its name"}) {
      const std::string bytes = binaryStl(header);
      checkSame(outside("a.stl", bytes, block), textFile("a.stl", bytes));
    }
    for (const std::string& text : {kText, kOff, kObj, kObj + "\n", kPlainObj})
      checkSame(outside("a", text, block), textFile("a", text));
  }
}

TEST_CASE("byte reader: of a file in blocks no more is in memory at once") {
  // Its beginning is looked at, which says what it is.
  std::string bytes = binaryStl("long");
  const std::string facets = bytes.substr(84);
  const std::uint32_t count = 6000;
  for (std::uint32_t i = 3; i < count; i += 3) bytes += facets;
  std::memcpy(&bytes[80], &count, sizeof count);
  REQUIRE(bytes.size() == 84 + std::size_t{50} * count);
  const auto source = std::make_shared<TestSource>(bytes, 1000);
  CHECK(io::read({"a.stl", {}, source}).parts[0].mesh.triangleCount() == count);
  CHECK(source->most == 65536);

  std::string text = kPlainObj;
  while (text.size() < 500'000) text += "f 1 2 3 # and again\n";
  const auto lines = std::make_shared<TestSource>(text, 1000);
  CHECK(io::read({"a.obj", {}, lines}).parts[0].mesh.triangleCount() > 4000);
  CHECK(lines->most == 65536);

  const auto views = std::make_shared<TestSource>(textOf(glbOf(textFile("a.obj", text))), 1000);
  CHECK(io::read({"a.glb", {}, views}).parts[0].mesh.triangleCount() > 4000);
  CHECK(views->most == 65536);
}

TEST_CASE("byte reader: a file in blocks is refused in the words of any other") {
  std::string stl = binaryStl("short");
  for (const std::string& bytes :
       {std::string(), stl.substr(0, 150), stl + "x", binaryPly(true, false).substr(0, 300),
        binaryPly(false, false).substr(0, 100),
        textOf(glbOf(textFile("a.obj", kObj))).substr(0, 900), kText.substr(0, 90),
        kObj.substr(0, 40), kObj + " 9", kPlainObj + "f 1 2 3\n\nf 1 \\\n2 x\n"}) {
    const std::string reported = failureOf([&] { io::read(outside("a.ply", bytes, 11)); });
    CHECK(reported == readingFails(textFile("a.ply", bytes)));
  }
}

TEST_CASE("byte reader: a file that has become shorter is refused") {
  const std::string bytes = binaryPly(true, false);
  const auto source = std::make_shared<TestSource>(bytes, 50);
  const File file = {"a.ply", {}, source};
  CHECK(io::read(file).parts.size() == 1);
  source->end = bytes.size() - 1;
  for (const bool isWhole : {false, true}) {
    const std::string reported =
        failureOf([&] { isWhole ? void(io::whole(file)) : void(io::read(file)); });
    CHECK(reported.starts_with("INPUT_UNREADABLE a.ply cannot be read from byte 0 on."));
  }
}

TEST_CASE("byte reader: what has no room in memory is refused with the numbers of the file") {
  const File file = {"a.stl", {}};
  CHECK_NOTHROW(io::requireRoomFor({50, 100}, file, 2400));
  CHECK(failureOf([&] {
          io::requireRoomFor({50e6, 100e6}, file, 1.2e9);
        }) ==
        "OUT_OF_MEMORY a.stl has 100 M triangles. To hold it alone takes about 2.4 GB of memory; "
        "this "
        "build has 1.2 GB, enough for about 50 M triangles. | Give it in parts, or remesh it with "
        "the "
        "native library.");
  CHECK(failureOf([&] { io::requireRoomFor({50e6, 100e6, 6}, file, 2.4e9); }) != "");
}
