// SPDX-License-Identifier: MIT
// Whole runs of both schemes: the edges are as long as they are asked to be, where they are asked.
#include "schemes/targets.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "geometry/triangle.h"
#include "measure/hausdorff.h"
#include "measure/mesh_report.h"
#include "schemes/best.h"
#include "schemes/remesh.h"
#include "schemes/rounds.h"
#include "support/runs.h"

using namespace remesher;

namespace {

constexpr Scheme kSchemes[] = {Scheme::Best, Scheme::Rounds};

// x⁶ + y⁶ + z⁶ = 1: a cube of flat sides whose edges and corners are rounded.
TriangleMesh pillow(int fineness) {
  TriangleMesh mesh = shapes::icosphere(fineness);
  for (Vec3& p : mesh.positions) p /= std::pow(p.array().pow(6).sum(), 1.0 / 6);
  return mesh;
}

// A sheet of side 2, full of bumps as steep as 45°.
TriangleMesh bumps() {
  TriangleMesh mesh;
  shapes::addSheet(mesh, 64, 64, [](int i, int k) {
    const double x = i / 32.0 - 1, y = k / 32.0 - 1;
    return Vec3(x, y, 0.05 * std::sin(20 * x) * std::cos(20 * y));
  });
  return mesh;
}

// How many times as dense vertices are right of x = border as left of it, beyond a way on which the
// edges grow.
double densityRatio(const TriangleMesh& mesh, double border, double way) {
  double vertices[] = {0, 0}, covered[] = {0, 0};
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
    const Vec3 &a = mesh.positions[mesh.indices[3 * t]],
               &b = mesh.positions[mesh.indices[3 * t + 1]],
               &c = mesh.positions[mesh.indices[3 * t + 2]];
    const double x = (a.x() + b.x() + c.x()) / 3;
    if (x > border - way && x < border) continue;
    const int side = x < border ? 0 : 1;
    vertices[side] += 0.5;  // of a closed mesh, about: it has twice as many triangles
    covered[side] += area(a, b, c);
  }
  return vertices[1] / covered[1] / (vertices[0] / covered[0]);
}

// The largest ratio between the target sizes at the two ends of an edge.
double steepest(const WorkingMesh& mesh, const SizeField& sizes) {
  double most = 1;
  for (Index i = 0; i < mesh.mesh().halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    if (!mesh.mesh().isEdge(h)) continue;
    const double from = sizes.at(mesh.at(mesh.mesh().origin(h)));
    const double to = sizes.at(mesh.at(mesh.mesh().tip(h)));
    most = std::max({most, from / to, to / from});
  }
  return most;
}

}  // namespace

TEST_CASE("targets: a density of 9 to 1 gives vertices in the ratio 9 to 1") {
  const TriangleMesh body = shapes::torus(72, 36);
  RemeshOptions options;
  options.adaptivity = 0;
  for (const Vec3& p : body.positions) options.density.push_back(p.x() > 1.5 ? 9 : 1);
  for (const Scheme scheme : kSchemes) {
    CAPTURE(int(scheme));
    options.scheme = scheme;
    double ratio = 0;
    // By the seed of annealing one number gives 7.8 to 10.4, four together 8.5 to 9.1.
    for (const Index vertices : {2000u, 2200u, 2400u, 2600u}) {
      options.vertices = vertices;
      const TriangleMesh mesh = remeshSurface(body, options, {}).mesh;
      // Gradation lets edges of 0.13 grow to 0.39 at a slope of 0.24, over a way of 1.1.
      ratio += densityRatio(mesh, 1.5, 1.1) / 4;
      CHECK(inspectMesh(mesh).minAngle.mean >= 52);
    }
    CHECK(ratio > 0.9 * 9);
    CHECK(ratio < 1.1 * 9);
  }
}

TEST_CASE("targets: the report's criteria keep no density from bumps smaller than triangles") {
  const TriangleMesh body = bumps();
  RemeshOptions options;
  options.vertices = 2400;
  options.adaptivity = 0;
  options.scheme = Scheme::Rounds;
  for (const Vec3& p : body.positions) options.density.push_back(p.x() > 0 ? 9 : 1);
  const TriangleMesh mesh = remeshSurface(body, options, {}).mesh;
  // Edges of 0.045 grow to 0.135 over a way of 0.4.
  const double ratio = densityRatio(mesh, 0, 0.4);
  CHECK(ratio > 0.9 * 9);
  CHECK(ratio < 1.1 * 9);
}

TEST_CASE("targets: edges are as long as asked for on average, even or graded") {
  const TriangleMesh body = pillow(12);
  RemeshOptions options;
  for (const Scheme scheme : kSchemes)
    for (const double adaptivity : {0.0, 1.0})
      for (const float density : {1.0f, 9.0f}) {
        CAPTURE(int(scheme));
        CAPTURE(adaptivity);
        CAPTURE(density);
        options.scheme = scheme;
        options.adaptivity = adaptivity;
        options.density.clear();
        for (const Vec3& p : body.positions) options.density.push_back(p.x() > 0 ? density : 1);
        options.edgeLength = 0.3;
        const double mean = shapes::meanEdge(remeshSurface(body, options, {}).mesh);
        CHECK(mean == doctest::Approx(0.3).epsilon(0.05));
      }
}

TEST_CASE("targets: target sizes at the ends of an edge differ by no more than the gradation") {
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
      CHECK(
          (scheme == Scheme::Best ? runBest(run, 1500, nullptr, {}) : runRounds(run, {1500}, {})));
      const double most = steepest(mesh, sizes);
      CHECK(most <= gradation);
      CHECK(most > 1.05);
    }
}

TEST_CASE("targets: sizes that follow curvature lower the error at the same count") {
  const TriangleMesh body = pillow(24);
  RemeshOptions options;
  for (const Scheme scheme : kSchemes) {
    CAPTURE(int(scheme));
    options.scheme = scheme;
    double before = 0, after = 0;
    // By the seed of annealing one number gains 1.2 to 1.45 times, six together 1.27 to 1.39, 1.33
    // on average. Nothing is annealed in rounds, which take three times as long: each gains 1.37 to
    // 1.47.
    const bool isAnnealed = scheme == Scheme::Best;
    std::vector<Index> numbers{2000, 2100};
    if (isAnnealed) numbers = {1950, 2000, 2050, 2100, 2150, 2200};
    for (const Index vertices : numbers) {
      options.vertices = vertices;
      options.adaptivity = 0;
      before += measureFidelity(body, remeshSurface(body, options, {}).mesh).rms;
      options.adaptivity = 1;
      const TriangleMesh graded = remeshSurface(body, options, {}).mesh;
      after += measureFidelity(body, graded).rms;
      CHECK(inspectMesh(graded).minAngle.mean >= 52);
    }
    CAPTURE(before / after);
    CHECK(after < before / (isAnnealed ? 1.2 : 1.3));
  }
}

TEST_CASE("targets: what no memory could hold is refused before it is tried") {
  RemeshOptions options;
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
  RemeshOptions options;
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
