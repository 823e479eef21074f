// SPDX-License-Identifier: MIT
// What becomes of every kind of hostile mesh: a table of how long it took, how it ended, what was
// said and what the result is like beside the input. For people; the laws are in the unit tests.
//   hostile [part of a name]        all whose name holds it
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "remesher.h"
#include "support/hostile_shapes.h"

using namespace remesher;

namespace {

constexpr unsigned kMostSeconds = 30;

struct Case {
  std::string name;
  std::function<TriangleMesh()> make;
  RemeshOptions options = {};
};

RemeshOptions vertices(Index n) {
  RemeshOptions options;
  options.vertices = n;
  return options;
}

std::vector<Case> outOfShape() {
  using namespace shapes;
  return {{"triangle 1e-12 high", [] { return flatTriangle(1e-12); }},
          {"triangle 1e-12 high to 1000", [] { return flatTriangle(1e-12); }, vertices(1000)},
          {"triangle 1e-300 high", [] { return flatTriangle(1e-300); }},
          {"tube 1e-3 by 1e4", [] { return tube(12, 2, 1e-3, 1e4); }},
          {"tube to 1000", [] { return tube(12, 2, 1e-3, 1e4); }, vertices(1000)},
          {"sheet 1e9", [] { return stretchedSheet(8, 1e9); }},
          {"sheet 1e9 to 1000", [] { return stretchedSheet(8, 1e9); }, vertices(1000)},
          {"sheet 1e4", [] { return stretchedSheet(20, 1e4); }},
          {"on a line 1e-9", [] { return nearlyOnALine(60, 1e-9); }},
          {"on a line 1e-15", [] { return nearlyOnALine(60, 1e-15); }},
          {"needles 1e-6", [] { return needles(300, 1e-6); }},
          {"needles 1e-14", [] { return needles(300, 1e-14); }}};
}

std::vector<Case> outliers() {
  using namespace shapes;
  std::vector<Case> cases;
  for (const double radii : {3.0, 10.0, 100.0, 1e4, 1e6, 1e12})
    cases.push_back({"spike " + std::to_string(int(std::log10(radii) * 10)) + "/10",
                     [radii] { return spikedSphere(12, radii); }});
  cases.push_back({"spike 100 of 10242", [] { return spikedSphere(32, 100); }});
  cases.push_back({"urchin 2", [] { return urchin(14, 8, 2); }});
  cases.push_back({"urchin 10", [] { return urchin(14, 8, 10); }});
  cases.push_back({"mixed 1e30", [] { return mixedScales(6, 1e30); }});
  cases.push_back({"mixed 1e-30", [] { return mixedScales(6, 1e-30); }});
  cases.push_back({"tiny 1e-30", [] { return scaled(icosphere(6), 1e-30); }});
  cases.push_back({"huge 1e30", [] { return scaled(icosphere(6), 1e30); }});
  cases.push_back({"offset 1e8", [] { return soups::moved(icosphere(10), Vec3(1e8, 1e8, 1e8)); }});
  cases.push_back({"offset 1e14", [] { return soups::moved(icosphere(10), Vec3(1e14, 0, 0)); }});
  return cases;
}

std::vector<Case> glued() {
  using namespace shapes;
  return {{"cubes at an edge", [] { return cubesSharingAnEdge(4); }},
          {"cubes at a corner", [] { return cubesSharingACorner(4); }},
          {"doubled sheet", [] { return doubledSheet(8); }},
          {"flat balloon", [] { return flatBalloon(8); }},
          {"doubled sphere", [] { return doubledSphere(8); }},
          {"Moebius", [] { return moebiusStrip(40); }},
          {"Klein", [] { return kleinBottle(24, 12); }},
          {"book of 10", [] { return book(10, 6); }},
          {"book of 200", [] { return book(200, 3); }}};
}

std::vector<Case> many() {
  using namespace shapes;
  return {{"wheel 10000", [] { return wheel(10000); }},
          {"hole 100000", [] { return annulus(100000); }},
          {"loose 100000", [] { return looseTriangles(100000); }},
          {"assembly", [] { return assembly(46, 390, 10000); }}};
}

std::vector<Case> senseless() {
  using namespace shapes;
  RemeshOptions exact = {};
  exact.maxError = 1e-9;
  RemeshOptions split = exact;
  split.splitObtuse = true;
  RemeshOptions fine = {};
  fine.edgeLength = 1e-4;
  return {{"maxError 1e-9", [] { return icosphere(20); }, exact},
          {"maxError 1e-9 splitObtuse", [] { return icosphere(20); }, split},
          {"edgeLength 1e-4", [] { return icosphere(20); }, fine}};
}

double userSeconds() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return double(used.ru_utime.tv_sec) + 1e-6 * double(used.ru_utime.tv_usec);
}

void print(const char* what, const MeshReport& r) {
  std::printf(
      "    %-4s V %zu F %zu comp %zu open %zu nonman %zu chi %ld degenerate %zu angle %.4g/%.4g\n",
      what, r.vertices, r.triangles, r.components, r.boundaryEdges, r.nonManifoldEdges,
      r.eulerCharacteristic, r.degenerateTriangles, r.minAngle.worst, r.minAngle.mean);
}

void run(const Case& input) {
  const rlimit limit{kMostSeconds, kMostSeconds};
  setrlimit(RLIMIT_CPU, &limit);
  const TriangleMesh mesh = input.make();
  const double start = userSeconds();
  try {
    const RemeshResult result = remesh(mesh, input.options);
    constexpr const char* kStopped[] = {"target", "fidelity", "max-error", "cancelled", "limits"};
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    std::printf("%s: %.2f s, %ld MB, stopped %s, H %.3g\n", input.name.c_str(),
                userSeconds() - start, used.ru_maxrss / 1024, kStopped[int(result.report.stopped)],
                result.report.fidelity ? result.report.fidelity->hausdorff : 0);
    print("in", result.report.input);
    print("out", *result.report.output);
    for (const Warning& warning : result.report.warnings)
      std::printf("    %s %zu\n", warning.code.c_str(), warning.count);
  } catch (const Error& error) {
    std::printf("%s: %.2f s, %s %s\n", input.name.c_str(), userSeconds() - start,
                std::string(name(error.code)).c_str(), error.what());
  } catch (const std::exception& error) {
    std::printf("%s: %.2f s, EXCEPTION %s\n", input.name.c_str(), userSeconds() - start,
                error.what());
  }
}

void runInChild(const Case& input) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    run(input);
    std::fflush(stdout);
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFSIGNALED(status)) std::printf("%s: SIGNAL %d\n", input.name.c_str(), WTERMSIG(status));
}

}  // namespace

int main(int count, char** words) {
  const std::string part = count > 1 ? words[1] : "";
  for (const auto& group : {outOfShape(), outliers(), glued(), many(), senseless()})
    for (const Case& input : group)
      if (input.name.find(part) != std::string::npos) runInChild(input);
}
