// SPDX-License-Identifier: MIT
// Counts how often each fallback and each limit of work fires on a file: plain, in fewer and in
// more vertices, with its shape preferred, within a bound, with limits of every edge and angle, as
// quads, with common faces, in a region, repaired and baked.
//   fires FILE    prints a line of JSON for each run: its name, and the count of each name that
//   fired
#include <cstdio>
#include <exception>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/fires.h"
#include "remesher.h"

using namespace remesher;

namespace {

std::map<std::string, std::size_t, std::less<>>& counts() {
  static std::map<std::string, std::size_t, std::less<>> only;
  return only;
}

FileBundle load(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {{path, {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()}}, {}};
}

// Grey pictures in place of the first images of a file: which fallbacks of painting fire hardly
// depends on what they show.
std::vector<Picture> greyPictures() {
  constexpr int kImages = 32, kSide = 64, kGrey = 128;
  std::vector<Picture> pictures;
  for (int i = 0; i < kImages; ++i) {
    Picture picture;
    picture.name = std::to_string(i);
    picture.type = "image/png";
    picture.width = picture.height = kSide;
    picture.texels.assign(std::size_t{4} * kSide * kSide, kGrey);
    pictures.push_back(picture);
  }
  return pictures;
}

// Prints what fired during a run; an Error is a result, too.
void count(std::string_view name, const std::function<void()>& run) {
  counts().clear();
  std::string error;
  try {
    run();
  } catch (const Error& failure) {
    error = failure.what();
  }
  const nlohmann::ordered_json line = {{"run", name}, {"error", error}, {"fired", counts()}};
  std::puts(line.dump().c_str());
  std::fflush(stdout);
}

// A model, and what options are relative to.
struct Model {
  FileBundle input;
  double diagonal = 1;
  std::size_t triangles = 0;

  void remeshed(const RemeshOptions& options) const { remeshFile(input, "out.glb", options); }
};

RemeshOptions toHalf() {
  RemeshOptions half;
  half.ratio = 0.5;
  return half;
}

RemeshOptions toFew() {
  RemeshOptions few;
  few.ratio = 0.05;
  few.tooFew = TooFew::Raise;
  return few;
}

void runTriangles(const Model& model) {
  count("half", [&] { model.remeshed(toHalf()); });
  count("few", [&] { model.remeshed(toFew()); });
  RemeshOptions more, shape = toHalf(), rounds = toHalf(), bound;
  more.ratio = 2;
  count("more", [&] { model.remeshed(more); });
  shape.prefer = Prefer::Shape;
  count("shape", [&] { model.remeshed(shape); });
  rounds.scheme = Scheme::Rounds;
  count("rounds", [&] { model.remeshed(rounds); });
  bound.maxError = 0.5;
  count("bound", [&] { model.remeshed(bound); });
  bound.ratio = 0.5;
  count("bound and number", [&] { model.remeshed(bound); });
}

void runLimits(const Model& model) {
  RemeshOptions wanted, half = toHalf();
  wanted.minAngle = half.minAngle = 25;
  count("angle", [&] { model.remeshed(wanted); });
  count("half, angle", [&] { model.remeshed(half); });
  half.minAngle.reset();
  half.minEdge = 0.02 * model.diagonal;
  half.maxEdge = 0.05 * model.diagonal;
  count("half, edges", [&] { model.remeshed(half); });
}

void runQuads(const Model& model) {
  RemeshOptions quads = toHalf();
  quads.quads = true;
  count("quads", [&] { model.remeshed(quads); });
  quads.symmetry = Symmetry::X;
  count("quads, symmetric", [&] { model.remeshed(quads); });
  quads.symmetry = Symmetry::Auto;
  quads.maxError = 0.5;
  count("quads, bound", [&] { model.remeshed(quads); });
}

void runParts(const Model& model) {
  RemeshOptions conform = toHalf(), welded = toHalf(), region = toHalf();
  conform.conform = true;
  count("conform", [&] { model.remeshed(conform); });
  welded.weld = 1;
  count("weld", [&] { model.remeshed(welded); });
  for (Index t = 0; t < model.triangles / 2; ++t) region.region.push_back(t);
  count("region", [&] { model.remeshed(region); });
}

void runRepairs(const Model& model) {
  for (const auto& [name, way] :
       {std::pair("auto", Repair::Auto), std::pair("holes", Repair::Holes),
        std::pair("solid", Repair::Solid), std::pair("wrap", Repair::Wrap)}) {
    RemeshOptions alone, first = toFew();
    alone.repair = first.repair = way;
    count(std::string("repair ") + name, [&] { repairFile(model.input, "out.glb", alone); });
    count(std::string("remesh, repair ") + name, [&] { model.remeshed(first); });
  }
}

void runAll(const std::string& path) {
  Model model;
  model.input = load(path);
  count("inspect", [&] {
    const MeshReport report = inspectFile(model.input).input;
    model.diagonal = report.diagonal, model.triangles = report.triangles;
  });
  runTriangles(model);
  runLimits(model);
  runQuads(model);
  runParts(model);
  runRepairs(model);
  RemeshOptions baked = toHalf();
  baked.textures = Textures::Bake;
  model.input.pictures = greyPictures();
  count("bake", [&] { model.remeshed(baked); });
}

}  // namespace

void remesher::fires(std::string_view name) { ++counts()[std::string(name)]; }

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "fires FILE\n");
    return 2;
  }
  try {
    runAll(argv[1]);
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "%s\n", failure.what());
    return 1;
  }
  return 0;
}
