// SPDX-License-Identifier: MIT
// Repairs a file as `remesher repair` does, natively, and says what fired on the way.
//   mended IN OUT [solid|wrap|holes]    prints a line of JSON: seconds of the processor, the
//   repair's report, its warnings, what fired, or the error
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/fires.h"
#include "remesher.h"

using namespace remesher;
using Json = nlohmann::ordered_json;

namespace {

std::map<std::string, std::size_t, std::less<>>& fired() {
  static std::map<std::string, std::size_t, std::less<>> only;
  return only;
}

File load(const std::filesystem::path& path, const std::string& name) {
  std::ifstream stream(path, std::ios::binary);
  return {name, {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()}};
}

// With the files beside it that it may refer to.
FileBundle bundleOf(const std::filesystem::path& path) {
  FileBundle bundle;
  bundle.file = load(path, path.string());
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  if (path.extension() != ".obj" && path.extension() != ".gltf") return bundle;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".mtl" || extension == ".bin")
      bundle.resources.push_back(load(entry.path(), entry.path().filename().string()));
  }
  return bundle;
}

Repair wayNamed(std::string_view name) {
  if (name == "solid") return Repair::Solid;
  if (name == "wrap") return Repair::Wrap;
  return name == "holes" ? Repair::Holes : Repair::Auto;
}

Json inJson(const Report& report) {
  Json warnings = Json::array();
  for (const Warning& warning : report.warnings)
    warnings.push_back({{"code", warning.code}, {"count", warning.count}});
  const RepairReport& repair = *report.repair;
  return {{"mode", repair.mode},
          {"reason", repair.reason},
          {"holes", repair.holes},
          {"shells", repair.shells},
          {"turned", repair.turned},
          {"lost", repair.lost},
          {"crossings", repair.selfIntersections[1]},
          {"warnings", warnings}};
}

}  // namespace

void remesher::fires(std::string_view name) { ++fired()[std::string(name)]; }

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "mended IN OUT [solid|wrap|holes]\n");
    return 2;
  }
  RemeshOptions options;
  options.repair = wayNamed(argc > 3 ? argv[3] : "auto");
  Json line;
  try {
    const FileBundle input = bundleOf(argv[1]);
    const std::clock_t start = std::clock();
    const RemeshFileResult result = repairFile(input, argv[2], options);
    line["seconds"] = double(std::clock() - start) / CLOCKS_PER_SEC;
    line["report"] = inJson(result.report);
    const std::vector<std::uint8_t>& bytes = result.files.front().bytes;
    std::ofstream(argv[2], std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
  } catch (const Error& error) {
    line["error"] = error.what();
  }
  line["fired"] = fired();
  std::puts(line.dump().c_str());
}
