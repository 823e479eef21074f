// SPDX-License-Identifier: MIT
#include "remesh/quads/shape/smoothing.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "original/surface/surface_walk.h"
#include "remesh/quads/mesh/quad_check.h"
#include "remesh/quads/pair/pairing.h"
#include "support/working_meshes.h"

using namespace remesher;

namespace {

struct Smoothed {
  explicit Smoothed(const TriangleMesh& input)
      : surface(shapes::surfaceOf(input)), ground(surface), frames(ground) {
    const CrossField field = makeCrossField(ground, frames, 0.3);
    quads = splitPairs(ground, pairTriangles(ground, frames, field));
  }

  double worst() {
    const MovingQuads moving(quads, ground);
    double least = 1;
    for (Index q = 0; q < quads.quads.size(); ++q) least = std::min(least, moving.quality(q));
    return least;
  }
  // Σ |corner − corner of the fitted rectangle|².
  double unevenness() const {
    double sum = 0;
    for (const auto& [a, b, c, d] : quads.quads) {
      const Quad corners = {quads.position(a), quads.position(b), quads.position(c),
                            quads.position(d)};
      const Quad rectangle = fittedRectangle(corners, 0);
      for (std::size_t i = 0; i < 4; ++i) sum += (corners[i] - rectangle[i]).squaredNorm();
    }
    return sum;
  }

  OriginalSurface surface;
  WorkingMesh ground;
  FaceFrames frames;
  QuadMesh quads;
};

}  // namespace

TEST_CASE(
    "smoothing: quads come nearer to rectangles, vertices stay on the surface, corners at all") {
  for (const TriangleMesh& shape :
       {shapes::icosphere(5), shapes::torus(24, 10), shapes::cube(4), shapes::cylinder(24, 6)}) {
    Smoothed smoothed(shape);
    const QuadMesh before = smoothed.quads;
    const double uneven = smoothed.unevenness(), worst = smoothed.worst();
    MovingQuads moving(smoothed.quads, smoothed.ground);
    smoothToRectangles(moving, 8, std::vector<char>(before.vertices.size(), 0));
    CHECK((smoothed.unevenness() < uneven || uneven < 1e-12));  // a cube's are squares already
    CHECK(smoothed.worst() >= std::min(worst, 0.5));
    CHECK(check(smoothed.quads) == "");
    for (Index v = 0; v < before.vertices.size(); ++v) {
      const Placement &now = smoothed.quads.vertices[v], &then = before.vertices[v];
      CHECK(now.kind == then.kind);
      if (now.kind == VertexKind::Corner) CHECK(now.position == then.position);
      if (now.kind == VertexKind::Curve) CHECK(now.on.chain == then.on.chain);
      if (now.kind == VertexKind::Interior)
        CHECK((smoothed.surface.position(now.at) - now.position).norm() < 1e-9);
    }
  }
}

TEST_CASE("smoothing: a vertex that was pulled over its neighbours is put back") {
  Smoothed smoothed(shapes::grid(6, 6));
  for (Placement& place : smoothed.quads.vertices)
    if (place.kind == VertexKind::Interior && (place.position - Vec3(3, 3, 0)).norm() < 0.1)
      place = smoothed.ground.onSurface(
          closestPointFrom(smoothed.surface, place.at, place.position + Vec3(0.9, 0.8, 0)));
  REQUIRE(smoothed.worst() < 0);
  MovingQuads moving(smoothed.quads, smoothed.ground);
  mendCorners(moving, std::vector<char>(smoothed.quads.vertices.size(), 0));
  CHECK(smoothed.worst() > 0.4);
}

TEST_CASE("smoothing: no inner vertex takes the place of a corner") {
  Smoothed smoothed(shapes::grid(6, 6));
  MovingQuads moving(smoothed.quads, smoothed.ground);
  std::size_t inner = 0;
  for (Index v = 0; v < smoothed.quads.vertices.size(); ++v) {
    if (smoothed.quads.vertices[v].kind != VertexKind::Interior) continue;
    ++inner;
    CHECK_FALSE(moving.placeNear(v, {-1, -1, 0}));
    CHECK_FALSE(moving.placeNear(v, {6, 6, 0}));
    CHECK(moving.placeNear(v, {1, 1, 0}));
    CHECK(moving.placeNear(v, {5, 2.5, 0}));
  }
  CHECK(inner > 0);
}

TEST_CASE("smoothing: a flat quad between curves counts as folded once it is turned over") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::cylinder(24, 6));
  const WorkingMesh ground(surface);
  QuadMesh quads;
  for (Index v = 0; v < ground.mesh().vertexCount(); ++v) {
    const Placement place = ground.placement(Vertex(v));
    if (place.kind == VertexKind::Curve && place.position.z() > 0) quads.vertices.push_back(place);
  }
  REQUIRE(quads.vertices.size() > 12);
  const auto angle = [](const Placement& place) {
    return std::atan2(place.position.y(), place.position.x());
  };
  std::sort(quads.vertices.begin(), quads.vertices.end(),
            [&](const Placement& a, const Placement& b) { return angle(a) < angle(b); });
  const auto quarter = Index(quads.vertices.size() / 4);
  quads.quads = {{0, quarter, 2 * quarter, 3 * quarter}};
  quads.curves = {{kNone, kNone, kNone, kNone}};
  CHECK(MovingQuads(quads, ground).quality(0) > 0.7);
  std::swap(quads.quads[0][1], quads.quads[0][3]);
  CHECK(MovingQuads(quads, ground).quality(0) < -0.7);
}
