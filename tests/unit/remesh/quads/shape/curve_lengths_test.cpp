// SPDX-License-Identifier: MIT
#include "remesh/quads/shape/curve_lengths.h"

#include <doctest/doctest.h>

#include <cmath>
#include <optional>

#include "remesh/quads/mesh/quad_check.h"
#include "remesh/quads/pair/pairing.h"
#include "support/working_meshes.h"

using namespace remesher;

namespace {

struct PipeQuads {
  // So many edges around the pipe, and quads about so long.
  PipeQuads(int around, double length) {
    TriangleMesh pipe;
    shapes::addSheet(pipe, around, 8, [&](int k, int row) {
      return Vec3(shapes::onCircle(k, around) + Vec3(0, 0, 0.25 * row));
    });
    surface = shapes::surfaceOf(pipe);
    ground.emplace(*surface);
    const FaceFrames frames(*ground);
    const CrossField field = makeCrossField(*ground, frames, length);
    quads = splitPairs(*ground, pairTriangles(*ground, frames, field));
  }

  double rims() const {
    double sum = 0;
    for (Index q = 0; q < quads.quads.size(); ++q)
      for (std::size_t i = 0; i < 4; ++i)
        if (quads.curves[q][i] != kNone)
          sum += (quads.position(quads.quads[q][i]) - quads.position(quads.quads[q][(i + 1) % 4]))
                     .norm();
    return sum;
  }

  // Vertices slide towards the beginning of their chain.
  void crowd() {
    for (Placement& place : quads.vertices) {
      if (place.kind != VertexKind::Curve) continue;
      const double length = surface->curves().chains()[place.on.chain].length();
      const double share = place.on.arc / length;
      place = ground->onCurve({place.on.chain, length * share * std::sqrt(share)});
    }
  }

  std::optional<OriginalSurface> surface;
  std::optional<WorkingMesh> ground;
  QuadMesh quads;
};

}  // namespace

TEST_CASE("curve lengths: crowded vertices spread along their loop until it is as long again") {
  PipeQuads pipe(24, 0.3);
  const double whole = pipe.rims();
  pipe.crowd();
  REQUIRE(pipe.rims() < 0.999 * whole);
  keepCurveLengths(pipe.quads, *pipe.ground);
  // As many vertices as bends, or twice as many: they are found exactly.
  CHECK(pipe.rims() == doctest::Approx(whole).epsilon(1e-9));
  CHECK(check(pipe.quads) == "");
}

TEST_CASE("curve lengths: loops that are long enough stay as they are") {
  PipeQuads pipe(24, 0.3);
  const QuadMesh before = pipe.quads;
  keepCurveLengths(pipe.quads, *pipe.ground);
  for (Index v = 0; v < before.vertices.size(); ++v)
    CHECK(pipe.quads.position(v) == before.position(v));
}
