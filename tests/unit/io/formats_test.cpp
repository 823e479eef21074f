// SPDX-License-Identifier: MIT
#include "io/formats.h"

#include <doctest/doctest.h>

#include <string>

#include "io/files.h"
#include "remesher.h"

using namespace remesher;
using namespace remesher::test;

TEST_CASE("formats: converting counts the polygons that become triangles, if they might stay") {
  const std::string points = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n2 1 0\n";
  const std::string off = "OFF\n6 2 0\n" + points;
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\n"
      "property float z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n" +
      points;
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\n";
  const auto cut = [](const std::string& name, const std::string& text, const std::string& output) {
    std::size_t count = 0;
    for (const Warning& warning : convertFile({textFile(name, text), {}}, output).warnings)
      if (warning.code == "POLYGONS_CUT") count += warning.count;
    return count;
  };
  const std::string mixed = "4 0 1 2 3\n3 1 4 2\n", quads = "4 0 1 2 3\n4 1 4 5 2\n";
  for (const std::string output : {"a.obj", "a.off", "a.glb", "a.msh"}) {
    CHECK(cut("a.off", off + mixed, output) == 1);
    CHECK(cut("a.ply", ply + mixed, output) == 1);
    CHECK(cut("a.obj", obj + "f 1 2 3 4\nf 2 5 3\n", output) == 1);
    CHECK(cut("a.off", off + quads, output) == 0);
  }
  CHECK(cut("a.ply", ply + mixed, "a.ply") == 0);
  CHECK(cut("a.off", off + mixed, "a.stl") == 0);
}

TEST_CASE("formats: repair counts the quads that it cuts, if they might stay") {
  const std::string box =
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
      "f 4 3 2 1\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  RemeshOptions options;
  options.repair = Repair::Auto;
  const auto cut = [&](const std::string& text, const std::string& output) {
    std::size_t count = 0;
    for (const Warning& warning :
         repairFile({textFile("a.obj", text), {}}, output, options).report.warnings)
      if (warning.code == "POLYGONS_CUT") count += warning.count;
    return count;
  };
  CHECK(cut(box, "a.obj") == 5);
  CHECK(cut(box, "a.stl") == 0);
  CHECK(cut(box + "f 5 6 7 8\n", "a.obj") == 0);
}

TEST_CASE("formats: an inspection speaks of no result") {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
      "element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n0 1\n";
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 1 2\n";
  for (const File& file : {textFile("a.ply", ply), textFile("a.obj", obj)}) {
    const std::vector<Warning> warnings = inspectFile({file, {}}).warnings;
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0].code == "NOT_TRIANGLES");
    CHECK(warnings[0].message.find("result") == std::string::npos);
  }
}

TEST_CASE("formats: where the file itself is the result, nothing of it is said to be lost") {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\nelement face 4\nproperty list uchar int vertex_indices\n"
      "property uchar flags\nelement edge 1\nproperty int vertex1\nproperty int vertex2\n"
      "end_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
      "3 0 2 1 7\n3 0 1 3 7\n3 1 2 3 7\n3 2 0 3 7\n0 1\n";
  const FileBundle file{textFile("a.ply", ply), {}};
  RemeshOptions options;
  options.repair = Repair::Auto;
  const RemeshFileResult repaired = repairFile(file, "b.ply", options);
  const ConvertFileResult converted = convertFile(file, "b.ply");
  CHECK(textOf(repaired.files.at(0)) == ply);
  CHECK(textOf(converted.files.at(0)) == ply);
  CHECK(repaired.report.warnings.empty());
  CHECK(converted.warnings.empty());
  CHECK(convertFile(file, "b.obj").warnings.size() == 2);
}

TEST_CASE("formats: a repaired STL has its own number of facets") {
  const std::string obj =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  std::string stl = textOf(convertFile({textFile("a.obj", obj), {}}, "a.stl").files.at(0));
  stl[80] = 1;
  RemeshOptions options;
  options.repair = Repair::Auto;
  CHECK(textOf(repairFile({textFile("a.stl", stl), {}}, "b.stl", options).files.at(0))[80] == 4);
}
