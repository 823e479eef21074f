// SPDX-License-Identifier: MIT
#include "remesh/accuracy/narrow_sizes.h"

#include <doctest/doctest.h>

#include <cmath>

#include "remesh/steps/adapt.h"
#include "support/working_meshes.h"

using namespace remesher;

namespace {

constexpr std::size_t kVertices = 2000;

// A sphere with a spine much narrower than the edges of a mesh of so many vertices.
TriangleMesh spinySphere() {
  TriangleMesh mesh = shapes::icosphere(24);
  for (Vec3& p : mesh.positions) {
    const double away = (p.normalized() - Vec3::UnitZ()).norm();
    p *= 1 + 0.2 * std::exp(-away * away / 0.002);
  }
  return mesh;
}

// Its mesh, of sizes that follow curvature so much.
struct CoarseRun {
  explicit CoarseRun(double adaptivity)
      : sizes(surface, {.vertices = double(kVertices), .adaptivity = adaptivity}),
        projector(surface, Projection::Patches, 2 * sizes.mean()) {
    matchCount(run, kVertices);
  }

  OriginalSurface surface = shapes::surfaceOf(spinySphere());
  SizeField sizes;
  Projector projector;
  WorkingMesh mesh{surface};
  Run run{mesh, projector, sizes, {}};
};

}  // namespace

TEST_CASE("narrow_sizes: smaller where the surface is lost, the same elsewhere") {
  CoarseRun coarse(0.1);
  const SizeField before = coarse.sizes;
  const std::size_t more = narrowSizes(coarse.run);
  CHECK(more > 0);
  CHECK(more < kVertices / 20);
  std::size_t lower = 0;
  for (Index i = 0; i < coarse.surface.mesh().vertexCapacity(); ++i) {
    const Vertex v(i);
    const Vec3& p = coarse.surface.positions()[v];
    CHECK(coarse.sizes.at(v) <= before.at(v));
    lower += std::size_t(coarse.sizes.at(v) < before.at(v));
    if (p.normalized().z() < 0) CHECK(coarse.sizes.at(v) == before.at(v));
  }
  CHECK(lower > 0);
}

TEST_CASE("narrow_sizes: sizes that are the same everywhere by wish stay so") {
  CoarseRun coarse(0);
  CHECK(narrowSizes(coarse.run) == 0);
  CHECK(coarse.sizes.isEven());
}
