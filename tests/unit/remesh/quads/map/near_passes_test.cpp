// SPDX-License-Identifier: MIT
#include "remesh/quads/map/near_passes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "remesh/quads/field/singularities.h"
#include "support/working_meshes.h"

using namespace remesher;

TEST_CASE("near passes: sums of integers tell how far lines are from the vertices they pass") {
  constexpr double kLength = 0.15;
  constexpr PassReach kReach{2, 30};
  const OriginalSurface surface = shapes::surfaceOf(shapes::icosphere(8));
  const WorkingMesh mesh(surface);
  const FaceFrames frames(mesh);
  const CrossField field = makeCrossField(mesh, frames, kLength);
  const VertexData<int> singular = quarterIndices(field, mesh, frames);
  const CutField cut = cutOpen(mesh, field, singular);
  const SeamlessSystem system({mesh, frames, cut, singular});
  const MapMaker maker(mesh, field, FaceData<double>(mesh.mesh().faceCapacity(), 1.0));
  const SeamlessMap map = maker.map(kLength).value();
  const std::vector<NearPass> passes = nearPasses({mesh, singular, cut, system}, map, kReach);
  CHECK(!passes.empty());
  const auto valueOf = [&](const IntegerSum& sum) {
    double value = 0;
    for (const auto& [variable, x] : sum) {
      REQUIRE(variable >= system.realCount());
      value += x * map.integers[variable - system.realCount()];
    }
    return std::abs(value);
  };
  for (const NearPass& pass : passes) {
    CHECK(valueOf(pass.across) <= kReach.across);
    CHECK(valueOf(pass.along) == doctest::Approx(pass.quads));
    CHECK(pass.quads <= kReach.along);
  }
}
