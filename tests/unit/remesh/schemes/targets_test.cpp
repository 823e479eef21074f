// SPDX-License-Identifier: MIT
// How sizes change along edges, and targets that are refused. That edges are as long as they are
// asked to be is tests/package/sizes.test.js, in optimised code.
#include "remesh/schemes/targets.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "remesh/schemes/best.h"
#include "remesh/schemes/remesh.h"
#include "remesh/schemes/rounds.h"
#include "support/runs.h"

using namespace remesher;

namespace {

constexpr Scheme kSchemes[] = {Scheme::Best, Scheme::Rounds};

// The largest ratio between the target sizes at the two ends of an edge, if each edge were as long
// as the mean of these.
double steepest(const WorkingMesh& mesh, const SizeField& sizes) {
  double most = 1;
  for (Index i = 0; i < mesh.mesh().halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    if (!mesh.mesh().isEdge(h)) continue;
    const double from = sizes.at(mesh.at(mesh.mesh().origin(h)));
    const double to = sizes.at(mesh.at(mesh.mesh().tip(h)));
    const double length =
        (mesh.position(mesh.mesh().tip(h)) - mesh.position(mesh.mesh().origin(h))).norm();
    const double slope = std::abs(to - from) / length;
    most = std::max(most, (1 + slope / 2) / (1 - slope / 2));
  }
  return most;
}

}  // namespace

TEST_CASE("targets: over an edge's length target sizes change by no more than the gradation") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::torus(48, 24));
  std::vector<float> density;
  for (const Vec3& p : surface.positions().values()) density.push_back(p.x() > 0 ? 16 : 1);
  for (const Scheme scheme : kSchemes)
    for (const double gradation : {1.2, 2.0}) {
      CAPTURE(int(scheme));
      SizeField sizes(
          surface, {.vertices = 1500, .adaptivity = 1, .gradation = gradation, .density = density});
      Projector projector(surface, Projection::Patches, 2 * sizes.mean());
      WorkingMesh mesh(surface);
      Run run{mesh, projector, sizes, {}};
      CHECK((scheme == Scheme::Best ? runBest(run, {1500, Quality::Best, nullptr}, {})
                                    : runRounds(run, {1500}, {})));
      const double most = steepest(mesh, sizes);
      CHECK(most <= gradation);
      CHECK(most > 1.05);
    }
}

TEST_CASE("targets: what no memory could hold is refused before it is tried") {
  PartOptions options;
  const auto codeOf = [&](const TriangleMesh& mesh) {
    try {
      remeshSurface(mesh, options, {});
    } catch (const Error& error) {
      return error.code;
    }
    return ErrorCode::Internal;
  };
  const TriangleMesh body = shapes::tetrahedron();
  options.ratio = 1e12;
  CHECK(codeOf(body) == ErrorCode::OutOfMemory);
  options.ratio = {};
  for (const double length : {1e-12, 1e-300}) {
    options.edgeLength = length;
    CHECK(codeOf(body) == ErrorCode::OutOfMemory);
  }
}

TEST_CASE("targets: triangles that are all lines are no surface") {
  TriangleMesh lines;
  lines.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  lines.indices = {0, 1, 2};
  PartOptions options;
  for (const bool byCount : {true, false}) {
    if (byCount) options.vertices = 100;
    options.edgeLength = byCount ? std::optional<double>() : 0.1;
    try {
      remeshSurface(lines, options, {});
      CHECK(false);
    } catch (const Error& error) {
      CHECK(error.code == ErrorCode::NoTriangles);
    }
  }
}

TEST_CASE("targets: a refusal for want of memory has true numbers") {
  constexpr double kAddresses = 4294967296.0;
  const auto failure = [](const ModelSize& model, double target) -> std::string {
    try {
      requireRoom(model, target, kAddresses);
    } catch (const Error& error) {
      CHECK(error.code == ErrorCode::OutOfMemory);
      return error.what();
    }
    return "";
  };
  CHECK(failure({5.1e6, 10.2e6}, 1000) ==
        "This model has 10.2 M triangles; this build has memory for about 7.16 M.");
  CHECK(failure({3.5e6, 7e6}, 1000).empty());
  CHECK(failure({1e6, 2e6}, 20e6) ==
        "The target is 20 M vertices; beside this model of 1 M this build has memory for about "
        "5.16 M.");
  CHECK(failure({1e6, 2e6}, 5e6).empty());
  CHECK(failure({100, 200}, 1e300).find(" 0 ") == std::string::npos);
}
