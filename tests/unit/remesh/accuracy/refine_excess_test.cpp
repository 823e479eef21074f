// SPDX-License-Identifier: MIT
#include "remesh/accuracy/refine_excess.h"

#include <doctest/doctest.h>

#include "remesh/schemes/targets.h"
#include "remesh/steps/adapt.h"
#include "remesh/steps/delaunay.h"
#include "support/working_meshes.h"

using namespace remesher;

namespace {}  // namespace

TEST_CASE("refine excess: a fine mesh finds its way to the corners of a coarse original") {
  constexpr int kRounds = 12;
  const OriginalSurface surface = shapes::surfaceOf(shapes::icosphere(2), shapes::Features::None);
  for (const std::size_t vertices : {600, 1200}) {
    CAPTURE(vertices);
    SizeField sizes(surface, {double(vertices)});
    Projector projector(surface, Projection::Patches, 2 * sizes.mean());
    WorkingMesh mesh(surface);
    Run run{mesh, projector, sizes, {fidelityRule({})}};
    adaptToSizes(run, vertices, {});
    const ErrorBound bound(surface, 0.002 * surface.diagonal());
    ExcessSearch search(bound);
    REQUIRE_FALSE(search.find(mesh).empty());
    for (int i = 0; i < kRounds; ++i) {
      refineExcess(run, search.find(mesh), Moves::Allowed);
      delaunayFlips(mesh, run.asked.rule);
    }
    CHECK(search.find(mesh).empty());
    CHECK(check(mesh.mesh()).empty());
  }
}
