// SPDX-License-Identifier: MIT
#include "io/contents.h"

#include <doctest/doctest.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "io/files.h"
#include "io/formats.h"
#include "support/shapes.h"

using namespace remesher;
using namespace remesher::test;
using namespace std::string_view_literals;

namespace {

constexpr std::array kExtensions = {".glb", ".gltf", ".obj", ".off", ".ply", ".stl"};

// The first file of a ball in this format, by this name.
File ballIn(const std::string& extension, const std::string& name) {
  io::Model model;
  model.parts.push_back({"ball", shapes::icosphere(1), {Transform::Identity()}});
  if (extension != ".gltf") return {name, io::write(model, "a" + extension).files[0].bytes};
  // Written as text that holds its own data.
  const std::string text =
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,)"
      R"("componentType":5126,"type":"VEC3","count":3}],"bufferViews":[{"buffer":0,"byteLength":36}],)"
      R"("buffers":[{"byteLength":36,"uri":"data:;base64,)"
      "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"
      R"("}]})";
  return textFile(name, text);
}

}  // namespace

TEST_CASE("contents: a file of any format is known whatever it is called, and that is said") {
  for (const std::string extension : kExtensions)
    for (const std::string called : kExtensions)
      for (const std::string end : {"", ".gz"}) {
        CAPTURE(extension + " called " + called + end);
        const File file = ballIn(extension, "x" + called + end);
        CHECK(io::contentOf(file).extension == extension);
        const io::Model model = io::read(file);
        CHECK(model.parts.at(0).mesh.triangleCount() >= 1);
        const bool isWrong = extension != called;
        REQUIRE(model.warnings.size() == (isWrong ? 1 : 0));
        if (!isWrong) continue;
        CHECK(model.warnings[0].code == "NAME_CONTRADICTS");
        CHECK(model.warnings[0].message.find("called " + called) != std::string::npos);
      }
}

TEST_CASE("contents: names without an extension, or with one of no format, contradict nothing") {
  for (const std::string extension : kExtensions)
    for (const char* name : {"x", "x.model", "x.obj.bak"}) {
      const io::Model model = io::read(ballIn(extension, name));
      CHECK(model.warnings.empty());
    }
}

TEST_CASE("contents: what cannot be read is called what it is, by any name, with what to do") {
  struct Foreign {
    std::string_view bytes, what, advice;
  };
  const Foreign all[] = {
      {"<!DOCTYPE html>\n<html>", "a web page", "download"},
      {"\n <html lang=en>", "a web page", "download"},
      {"<?xml version=\"1.0\"?>\n<COLLADA>", "COLLADA", "Export"},
      {"<?xml version=\"1.0\"?><Error><Code>AccessDenied</Code>", "XML", "download"},
      {"{\"error\": \"not found\"}", "JSON", "download"},
      {"\x89PNG\r\n\x1A\n", "a picture (PNG)", "model itself"},
      {"\xFF\xD8\xFF\xE0", "a picture (JPEG)", "model itself"},
      {"%PDF-1.7", "PDF", "model itself"},
      {"PK\x03\x04..........file.txt", "a ZIP archive", "Unpack"},
      {"PK\x03\x04..........3D/3dmodel.model", "a 3MF package", "Unpack"},
      {"Kaydara FBX Binary  \0\x1A"sv, "an FBX file", "Export"},
      {"; FBX 7.3.0 project file", "an FBX file", "Export"},
      {"ISO-10303-21;\nHEADER;", "a STEP file", "Export"},
      {"BLENDER-v300", "a Blender file", "Export"},
      {"#VRML V2.0 utf8", "a VRML file", "Export"},
      {"  0\nSECTION\n  2\nHEADER\n", "a DXF file", "Export"},
      {"version https://git-lfs.github.com/spec/v1\noid sha256:0", "Git LFS", "git lfs pull"},
      {"\x1F\x8B\x08\0\0\0"sv, "gzip", "Unpack"},
  };
  for (const auto& [bytes, what, advice] : all)
    for (const std::string called : {".obj", ".stl", ".ply", ".off", ".glb", ".txt", ""}) {
      const std::string failure = readingFails(textFile("x" + called, bytes));
      CAPTURE(failure);
      CHECK(failure.starts_with("UNKNOWN_FORMAT x" + called + " is a"));
      CHECK(failure.find(what) != std::string::npos);
      CHECK(failure.find(advice) != std::string::npos);
    }
}

TEST_CASE("contents: texts that only look alike are left to their names") {
  CHECK(io::contentOf(textFile("a", "solidus\nv 1 2 3\n")).extension.empty());
  CHECK(io::contentOf(textFile("a", "plywood\n")).extension.empty());
  CHECK(io::contentOf(textFile("a", "so it is\nv 0 0 0\n")).extension.empty());
  CHECK(io::contentOf(textFile("a", "v five\n")).extension.empty());
  CHECK(io::contentOf(textFile("a", "3 1 0\n0 0 0\n")).extension.empty());
  CHECK(io::contentOf(textFile("a", "# remarks\n\ng\nusemtl x\nv 1 2 3\n")).extension == ".obj");
  CHECK(io::contentOf(textFile("a", "\xEF\xBB\xBFv 1 2 3\n")).extension == ".obj");
  CHECK(io::contentOf(textFile("a", "# remark\nCOFF\n3 1 0\n")).extension == ".off");
  CHECK(io::contentOf(textFile("a", "")).extension.empty());
}
