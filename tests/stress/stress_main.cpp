// SPDX-License-Identifier: MIT
// Remeshes random inputs, good and bad, with random options, and checks what must always hold: no
// crash and no endless run, errors only with a code of the caller's, exact counts, and for sound
// inputs the same topology without self-intersections. Not part of the tests: it runs as long as it
// is told. Each case runs in a process of its own.
//   stress [first seed] [number of cases] [scheme: best | rounds]
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "measure/mesh_report.h"
#include "measure/self_intersections.h"
#include "mesh/mesh_builder.h"
#include "remesher.h"
#include "support/shapes.h"
#include "support/soups.h"

using namespace remesher;

namespace {

constexpr unsigned kMostSeconds = 60;

struct Case {
  std::string description;
  bool isWild = false;  // coordinates as of a broken file
  TriangleMesh mesh;
  RemeshOptions options;
};

// A choice of whole numbers, numbers and chances from one seed.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : random_(seed) {
    for (int k = 0; k < 8; ++k) random_.number();
  }

  double number(double low, double high) { return low + (high - low) * random_.number(); }
  int whole(int low, int high) {
    return low + static_cast<int>((high - low + 1) * random_.number());
  }
  bool chance(double share) { return random_.number() < share; }
  Vec3 point() { return random_.point() - Vec3::Constant(0.5); }

 private:
  soups::Random random_;
};

TriangleMesh pickShape(Dice& dice, std::string& description) {
  switch (dice.whole(0, 6)) {
    case 0: {
      description = "soup";
      return soups::randomSoup(static_cast<std::size_t>(dice.whole(1, 60)), dice.number(0.05, 1),
                               static_cast<std::uint64_t>(dice.whole(1, 1 << 20)));
    }
    case 1:
      description = "sphere";
      return soups::sphere(dice.whole(2, 20));
    case 2:
      description = "square";
      return soups::square(dice.whole(1, 20));
    default: {
      const std::vector<shapes::Shape> all = shapes::all();
      const shapes::Shape& shape = all[dice.whole(0, static_cast<int>(all.size()) - 1)];
      description = shape.name;
      return shape.mesh;
    }
  }
}

// A wave: corners at one place move together.
void addNoise(TriangleMesh& mesh, double amount) {
  for (Vec3& p : mesh.positions) {
    const Vec3 q = p;
    p += amount * Vec3(std::sin(37 * q.x() + 11 * q.y()), std::sin(41 * q.y() + 13 * q.z()),
                       std::sin(43 * q.z() + 17 * q.x()));
  }
}

void damage(TriangleMesh& mesh, Dice& dice, std::string& description) {
  const int triangles = static_cast<int>(mesh.triangleCount());
  const auto pick = [&] { return static_cast<std::size_t>(dice.whole(0, triangles - 1)) * 3; };
  for (int times = dice.whole(1, 4); times > 0; --times) {
    const std::size_t t = pick();
    switch (dice.whole(0, 5)) {
      case 0:
        description += " hole";
        mesh.indices[t] = mesh.indices[t + 1];
        break;
      case 1:
        description += " flipped";
        std::swap(mesh.indices[t], mesh.indices[t + 1]);
        break;
      case 2:
        description += " twice";
        for (std::size_t k = 0; k < 3; ++k) mesh.indices.push_back(mesh.indices[t + k]);
        break;
      case 3:
        description += " spike";
        mesh.indices[t] = mesh.indices[pick()];
        break;
      case 4:
        description += " pinch";
        mesh.positions[mesh.indices[t]] = mesh.positions[mesh.indices[pick()]];
        break;
      default:
        description += " thrown";
        mesh.positions[mesh.indices[t]] += dice.point();
        break;
    }
  }
}

// What bit flips make of coordinates in a file of floats: other exponents, signs and digits.
void makeWild(TriangleMesh& mesh, Dice& dice) {
  const int last = static_cast<int>(mesh.positions.size()) - 1;
  for (int times = dice.whole(1, 6); times > 0; --times) {
    double& x = mesh.positions[dice.whole(0, last)][dice.whole(0, 2)];
    float value = static_cast<float>(x);
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    bits ^= 1u << dice.whole(0, 31);
    std::memcpy(&value, &bits, sizeof bits);
    if (std::isfinite(value)) x = value;
    if (dice.chance(0.2)) x = std::pow(10, dice.number(-38, 38));
    // Whole rows of vertices end at one place, or nearly.
    if (dice.chance(0.2))
      mesh.positions[dice.whole(0, last)] = mesh.positions[dice.whole(0, last)] * (1 + 1e-15);
  }
}

Case makeCase(std::uint64_t seed, std::optional<Scheme> scheme) {
  Dice dice(seed);
  Case result;
  result.mesh = pickShape(dice, result.description);
  if (dice.chance(0.3)) {
    const Vec3 scale(1, std::pow(10, dice.number(-3, 0)), std::pow(10, dice.number(-2, 0)));
    for (Vec3& p : result.mesh.positions) p = p.cwiseProduct(scale);
    result.description += " squashed";
  }
  if (dice.chance(0.3)) {
    addNoise(result.mesh, std::pow(10, dice.number(-3, -0.7)));
    result.description += " noisy";
  }
  if (dice.chance(0.3)) damage(result.mesh, dice, result.description);
  if (dice.chance(0.25)) {
    makeWild(result.mesh, dice);
    result.description += " wild";
    result.isWild = true;
  }
  if (dice.chance(0.15)) {
    const double size = std::pow(10, dice.number(-6, 6));
    const Vec3 away = dice.chance(0.5) ? Vec3(1000 * size * dice.point()) : Vec3(Vec3::Zero());
    for (Vec3& p : result.mesh.positions) p = size * p + away;
    result.description += " moved";
  }
  RemeshOptions& options = result.options;
  options.scheme = scheme.value_or(dice.chance(0.6) ? Scheme::Best : Scheme::Rounds);
  const double ratio = std::pow(4, dice.number(-1, 1));
  const double own = static_cast<double>(inspectMesh(result.mesh).vertices);
  options.vertices = static_cast<Index>(std::max(4.0, own * ratio));
  if (dice.chance(0.2)) options.projection = Projection::Current;
  if (dice.chance(0.2)) options.boundary = Boundary::Keep;
  if (dice.chance(0.3)) options.adaptivity = dice.number(0, 1);
  if (dice.chance(0.2)) options.detectFeatures = false;
  if (dice.chance(0.1)) options.splitObtuse = true;
  if (dice.chance(0.1)) options.fidelity = Fidelity::Strict;
  return result;
}

// A manifold as given, oriented, without self-intersections: what a result must be like as well.
bool isSound(const TriangleMesh& mesh) {
  return inspectMesh(mesh).degenerateTriangles == 0 && buildMesh(mesh).warnings.empty() &&
         selfIntersections(mesh).empty();
}

std::vector<std::string> judge(const Case& input, const RemeshResult& result) {
  std::vector<std::string> wrong;
  const auto expectEqual = [&wrong](const char* what, long actual, long expected) {
    if (actual != expected)
      wrong.push_back(std::string(what) + " " + std::to_string(actual) + ", not " +
                      std::to_string(expected));
  };
  for (const Vec3& p : result.mesh.positions)
    if (!p.allFinite()) return {"a coordinate is not finite"};
  for (const Index v : result.mesh.indices)
    if (v >= result.mesh.positions.size()) return {"an index is out of range"};
  const MeshReport before = inspectMesh(input.mesh), after = inspectMesh(result.mesh);
  if (result.report.stopped == Stopped::Target && !input.options.splitObtuse)
    expectEqual("vertices", long(after.vertices), long(*input.options.vertices));
  const auto& warnings = result.report.warnings;
  const bool isSaid = std::any_of(warnings.begin(), warnings.end(), [](const Warning& w) {
    return w.code == "NON_MANIFOLD_EDGES_MADE" || w.code == "SURFACE_OPENED";
  });
  if (after.nonManifoldEdges > before.nonManifoldEdges && !isSaid)
    expectEqual("non-manifold edges", long(after.nonManifoldEdges), long(before.nonManifoldEdges));
  if (before.boundaryEdges == 0 && !isSaid)
    expectEqual("open edges of a closed surface", long(after.boundaryEdges), 0);
  if (input.isWild) return wrong;
  expectEqual("degenerate triangles", long(after.degenerateTriangles), 0);
  if (!isSound(input.mesh)) return wrong;
  expectEqual("Euler characteristic", after.eulerCharacteristic, before.eulerCharacteristic);
  expectEqual("components", long(after.components), long(before.components));
  expectEqual("boundary loops", long(countBoundaryLoops(result.mesh)),
              long(countBoundaryLoops(input.mesh)));
  expectEqual("non-manifold edges", long(after.nonManifoldEdges), 0);
  expectEqual("intersecting triangles", long(selfIntersections(result.mesh).size()), 0);
  return wrong;
}

std::string describe(const Case& input) {
  const RemeshOptions& o = input.options;
  std::string text = input.description + " V " + std::to_string(inspectMesh(input.mesh).vertices) +
                     " -> " + std::to_string(*o.vertices);
  text += o.scheme == Scheme::Best ? " best" : " rounds";
  if (o.projection == Projection::Current) text += " current";
  if (o.boundary == Boundary::Keep) text += " keep";
  if (o.adaptivity) text += " adaptivity " + std::to_string(*o.adaptivity);
  if (!o.detectFeatures) text += " no-features";
  if (o.splitObtuse) text += " split-obtuse";
  if (o.fidelity) text += " strict";
  return text;
}

// What went wrong, to standard output; in the child process.
int runCase(std::uint64_t seed, const Case& input) {
  alarm(kMostSeconds);
  const std::string name = std::to_string(seed) + " (" + describe(input) + ")";
  const auto start = std::chrono::steady_clock::now();
  try {
    const RemeshResult result = remesh(input.mesh, input.options);
    const std::vector<std::string> wrong = judge(input, result);
    for (const std::string& what : wrong) std::printf("%s: %s\n", name.c_str(), what.c_str());
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (seconds > 10) std::printf("%s: %.1f s\n", name.c_str(), seconds);
    return wrong.empty() ? 0 : 1;
  } catch (const Error& error) {
    const bool isOurs = error.code == ErrorCode::Internal || error.code == ErrorCode::Cancelled;
    if (isOurs || std::getenv("STRESS_ERRORS"))
      std::printf("%s: error %s\n", name.c_str(), error.what());
    return isOurs ? 1 : 0;
  } catch (const std::exception& error) {
    std::printf("%s: exception %s\n", name.c_str(), error.what());
    return 1;
  }
}

bool runInChild(std::uint64_t seed, std::optional<Scheme> scheme) {
  const Case input = makeCase(seed, scheme);
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    const int status = runCase(seed, input);
    std::fflush(stdout);
    _exit(status);
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFSIGNALED(status))
    std::printf("%llu (%s): %s\n", static_cast<unsigned long long>(seed), describe(input).c_str(),
                WTERMSIG(status) == SIGALRM ? "does not end" : "crashes");
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

int main(int count, char** words) {
  const std::uint64_t first = count > 1 ? std::strtoull(words[1], nullptr, 10) : 1;
  const std::uint64_t cases = count > 2 ? std::strtoull(words[2], nullptr, 10) : 100;
  std::optional<Scheme> scheme;
  if (count > 3) scheme = std::string(words[3]) == "best" ? Scheme::Best : Scheme::Rounds;
  std::uint64_t failures = 0;
  for (std::uint64_t seed = first; seed < first + cases; ++seed)
    failures += !runInChild(seed, scheme);
  std::printf("%llu of %llu cases failed\n", static_cast<unsigned long long>(failures),
              static_cast<unsigned long long>(cases));
  return failures > 0 ? 1 : 0;
}
