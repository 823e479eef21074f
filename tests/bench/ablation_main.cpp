// SPDX-License-Identifier: MIT
// Remeshes a model by `best`, whole and with each step of the scheme left out in turn, to a number
// of vertices and to its neighbours: one number alone is chance.
//   ablation MODEL VERTICES [STEP…]    prints JSON: by step, the figures of each number. An empty
//                                      STEP: only those of the whole scheme
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "io/formats.h"
#include "io/model/bake.h"
#include "remesher.h"
#include "remesh/steps/left_out.h"

using namespace remesher;
using Json = nlohmann::ordered_json;

namespace {

// As many on either side of the wanted number, all within a percent of it.
constexpr int kNeighbors = 3;
constexpr double kStep = 0.003;

struct Ablation {
  std::string leftOut;
  std::set<std::string, std::less<>> asked;
};

Ablation& ablation() {
  static Ablation only;
  return only;
}

TriangleMesh load(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw Error(ErrorCode::InputUnreadable, path + " cannot be opened.");
  File file{path, {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()}};
  return io::mergeParts(io::bakeInstances(io::read(file)));
}

Json figuresOf(const TriangleMesh& mesh, double vertices) {
  RemeshOptions options;
  options.vertices = Index(std::lround(vertices));
  const Report report = remesh(mesh, options).report;
  double milliseconds = 0;
  for (const Phase& phase : report.phases) milliseconds += phase.milliseconds;
  const AngleStatistics& angles = report.output->minAngle;
  return {{"above50", angles.histogram[5]},      {"meanAngle", angles.mean},
          {"worstAngle", angles.worst},          {"hausdorff", report.fidelity->hausdorff},
          {"rms", report.fidelity->rms},         {"valence6", report.output->valence6},
          {"milliseconds", milliseconds}};
}

Json runsWithout(const std::string& step, const TriangleMesh& mesh, double vertices) {
  ablation().leftOut = step;
  Json runs = Json::array();
  for (int k = -kNeighbors; k <= kNeighbors; ++k)
    runs.push_back(figuresOf(mesh, vertices * (1 + kStep * k)));
  return runs;
}

}  // namespace

bool remesher::isLeftOut(std::string_view step) {
  ablation().asked.emplace(step);
  return step == ablation().leftOut;
}

int main(int count, char** words) {
  if (count < 3) {
    std::fprintf(stderr, "usage: ablation MODEL VERTICES [STEP…]\n");
    return 2;
  }
  try {
    const TriangleMesh mesh = load(words[1]);
    const double vertices = std::atof(words[2]);
    Json result = {{"", runsWithout("", mesh, vertices)}};
    std::vector<std::string> steps(words + 3, words + count);
    if (steps.empty()) steps.assign(ablation().asked.begin(), ablation().asked.end());
    for (const std::string& step : steps)
      if (!step.empty()) result[step] = runsWithout(step, mesh, vertices);
    std::printf("%s\n", result.dump().c_str());
  } catch (const Error& error) {
    std::fprintf(stderr, "%s %s\n", error.what(), error.hint.c_str());
    return 2;
  }
  return 0;
}
