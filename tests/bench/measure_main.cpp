// SPDX-License-Identifier: MIT
// The judge as a command, for developers and for the benchmark: how good a mesh is, and how near to
// its original. Everything the package reports is measured here to the end: distances proven,
// intersections counted.
//   measure original [result] [--json]
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/error.h"
#include "io/formats.h"
#include "io/model/bake.h"
#include "measure/hausdorff.h"
#include "measure/mesh_report.h"
#include "measure/self_intersections.h"

using namespace remesher;
using Json = nlohmann::ordered_json;

namespace {

TriangleMesh load(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw Error(ErrorCode::InputUnreadable, path + " cannot be opened.");
  File file{path, {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()}};
  return io::mergeParts(io::bakeInstances(io::read(file)));
}

Json describe(const TriangleMesh& mesh) {
  const MeshReport report = inspectMesh(mesh);
  const std::array<double, 6>& histogram = report.minAngle.histogram;
  return {{"vertices", report.vertices},
          {"triangles", report.triangles},
          {"components", report.components},
          {"boundaryEdges", report.boundaryEdges},
          {"boundaryLoops", countBoundaryLoops(mesh)},
          {"nonManifoldEdges", report.nonManifoldEdges},
          {"eulerCharacteristic", report.eulerCharacteristic},
          {"degenerateTriangles", report.degenerateTriangles},
          {"worstAngle", report.minAngle.worst},
          {"meanAngle", report.minAngle.mean},
          {"maxAngle", report.maxAngle},
          {"histogram", histogram},
          {"below30", histogram[0] + histogram[1] + histogram[2]},
          {"above50", histogram[5]},
          {"valence6", report.valence6},
          {"nonDelaunay", nonDelaunayPercentage(mesh)},
          {"selfIntersections", selfIntersections(mesh).size()}};
}

Json compare(const TriangleMesh& original, const TriangleMesh& result) {
  const DeviationBothWays d = measureDeviation(original, result, Maximum::Proven);
  const double percent = d.diagonal > 0 ? 100 / d.diagonal : 0;
  return {{"hausdorff", percent * std::max(d.toResult.maximum, d.toOriginal.maximum)},
          {"rms", percent * std::max(d.toResult.rms, d.toOriginal.rms)},
          {"hausdorffToResult", percent * d.toResult.maximum},
          {"hausdorffToOriginal", percent * d.toOriginal.maximum},
          {"rmsToResult", percent * d.toResult.rms},
          {"rmsToOriginal", percent * d.toOriginal.rms}};
}

void print(const Json& columns) {
  for (const auto& [name, values] : columns.items()) {
    std::printf("%-20s", name.c_str());
    for (const Json& value : values)
      if (value.is_array())
        for (const Json& share : value) std::printf(" %6.2f", share.get<double>());
      else
        std::printf(value.is_number_float() ? " %13.5f" : " %13.0f", value.get<double>());
    std::printf("\n");
  }
}

enum class Output { Table, Json };

void run(const std::vector<std::string>& paths, Output output) {
  Json result = {{"original", describe(load(paths[0]))}};
  if (paths.size() == 2) {
    result["result"] = describe(load(paths[1]));
    result["fidelity"] = compare(load(paths[0]), load(paths[1]));
  }
  if (output == Output::Json) {
    std::printf("%s\n", result.dump(2).c_str());
    return;
  }
  Json rows;
  for (const auto& [mesh, values] : result.items())
    for (const auto& [name, value] : values.items()) rows[name].push_back(value);
  print(rows);
}

}  // namespace

int main(int count, char** words) {
  std::vector<std::string> paths(words + 1, words + count);
  const Output output = std::erase(paths, "--json") > 0 ? Output::Json : Output::Table;
  if (paths.empty() || paths.size() > 2) {
    std::fprintf(stderr, "usage: measure original [result] [--json]\n");
    return 2;
  }
  try {
    run(paths, output);
  } catch (const Error& error) {
    std::fprintf(stderr, "%s %s\n", error.what(), error.hint.c_str());
    return 2;
  }
  return 0;
}
