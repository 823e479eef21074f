// SPDX-License-Identifier: MIT
// Counts how often each fallback and each limit of work fires on a file: plain, in fewer and in
// more vertices, with its shape preferred, within a bound, with limits of every edge and angle, as
// quads, with common faces, in a region, repaired and baked.
//   fires FILE    prints a line of JSON for each run: its name, and the count of each name that
//   fired
#include <cstdio>
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

void runAll(const std::string& path) {
  const FileBundle input = load(path);
  const auto remeshed = [&](const RemeshOptions& options) {
    remeshFile(input, "out.glb", options);
  };
  double diagonal = 1;
  std::size_t triangles = 0;
  count("inspect", [&] {
    const MeshReport report = inspectFile(input).input;
    diagonal = report.diagonal, triangles = report.triangles;
  });
  RemeshOptions half;
  half.ratio = 0.5;
  count("half", [&] { remeshed(half); });
  RemeshOptions few = half, shape = half, rounds = half, quads = half, draft = half;
  few.ratio = 0.05;
  few.tooFew = TooFew::Raise;
  count("few", [&] { remeshed(few); });
  RemeshOptions more;
  more.ratio = 2;
  count("more", [&] { remeshed(more); });
  shape.prefer = Prefer::Shape;
  count("shape", [&] { remeshed(shape); });
  rounds.scheme = Scheme::Rounds;
  count("rounds", [&] { remeshed(rounds); });
  RemeshOptions bound;
  bound.maxError = 0.5;
  count("bound", [&] { remeshed(bound); });
  bound.ratio = 0.5;
  count("bound and number", [&] { remeshed(bound); });
  quads.quads = true;
  count("quads", [&] { remeshed(quads); });
  quads.symmetry = Symmetry::X;
  count("quads, symmetric", [&] { remeshed(quads); });
  quads.symmetry = Symmetry::Auto;
  quads.maxError = 0.5;
  count("quads, bound", [&] { remeshed(quads); });
  RemeshOptions wanted, wantedOfHalf = half;
  wanted.minAngle = wantedOfHalf.minAngle = 25;
  count("angle", [&] { remeshed(wanted); });
  count("half, angle", [&] { remeshed(wantedOfHalf); });
  wantedOfHalf.minAngle.reset();
  wantedOfHalf.minEdge = 0.02 * diagonal;
  wantedOfHalf.maxEdge = 0.05 * diagonal;
  count("half, edges", [&] { remeshed(wantedOfHalf); });
  RemeshOptions conform = half, welded = half, region = half;
  conform.conform = true;
  count("conform", [&] { remeshed(conform); });
  welded.weld = 1;
  count("weld", [&] { remeshed(welded); });
  for (Index t = 0; t < triangles / 2; ++t) region.region.push_back(t);
  count("region", [&] { remeshed(region); });
  for (const auto& [name, way] :
       {std::pair("auto", Repair::Auto), std::pair("holes", Repair::Holes),
        std::pair("solid", Repair::Solid), std::pair("wrap", Repair::Wrap)}) {
    RemeshOptions alone, first = few;
    alone.repair = first.repair = way;
    count(std::string("repair ") + name, [&] { repairFile(input, "out.glb", alone); });
    count(std::string("remesh, repair ") + name, [&] { remeshed(first); });
  }
  RemeshOptions baked = half;
  baked.textures = Textures::Bake;
  FileBundle painted = input;
  painted.pictures = greyPictures();
  count("bake", [&] { remeshFile(painted, "out.glb", baked); });
}

}  // namespace

void remesher::fires(std::string_view name) { ++counts()[std::string(name)]; }

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "fires FILE\n");
    return 2;
  }
  runAll(argv[1]);
}
