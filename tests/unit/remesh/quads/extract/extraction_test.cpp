// SPDX-License-Identifier: MIT
#include "remesh/quads/extract/extraction.h"

#include <doctest/doctest.h>

#include <cmath>

#include "remesh/quads/mesh/quad_check.h"
#include "support/working_meshes.h"

using namespace remesher;

namespace {

struct ExtractedQuads {
  ExtractedQuads(const TriangleMesh& input, double length)
      : surface(shapes::surfaceOf(input)), mesh(surface), frames(mesh) {
    const FaceData<double> even(mesh.mesh().faceCapacity(), 1.0);
    const MapMaker maker(mesh, makeCrossField(mesh, frames, length), even);
    const SeamlessMap map = maker.map(length).value();
    counted = maker.countVertices(map);
    quads = extractQuads(mesh, map);
    areCurvesFollowed = followCurves(quads, mesh) == 0;
  }

  OriginalSurface surface;
  WorkingMesh mesh;
  FaceFrames frames;
  QuadMesh quads;
  double counted = 0;
  bool areCurvesFollowed = false;
};

}  // namespace

TEST_CASE("extraction: quads are sound, of the surface's kind, as many as were counted") {
  for (const auto& [shape, length] :
       {std::pair{shapes::icosphere(12), 0.2}, std::pair{shapes::torus(48, 20), 0.25},
        std::pair{shapes::cube(6), 0.75}, std::pair{shapes::grid(12, 9), 0.8}}) {
    const ExtractedQuads extracted(shape, length);
    CHECK(check(extracted.quads) == "");
    CHECK(kindOf(extracted.quads) == kindOf(extracted.mesh.mesh()));
    CHECK(double(extracted.quads.vertices.size()) ==
          doctest::Approx(extracted.counted).epsilon(1e-6));
    CHECK(extracted.areCurvesFollowed);
  }
}

TEST_CASE("extraction: a rectangle is divided in rows and columns") {
  const ExtractedQuads extracted(shapes::grid(12, 9), 0.75);  // 16 × 12
  CHECK(extracted.quads.quads.size() == 16 * 12);
  for (const auto& [a, b, c, d] : extracted.quads.quads) {
    const Vec3 across = extracted.quads.position(c) - extracted.quads.position(a);
    CHECK(std::abs(across.x()) == doctest::Approx(0.75).epsilon(1e-3));
    CHECK(std::abs(across.y()) == doctest::Approx(0.75).epsilon(1e-3));
  }
}

TEST_CASE("extraction: the edges of a cube are edges of quads, its corners vertices of three") {
  const ExtractedQuads extracted(shapes::cube(6), 1);
  CHECK(extracted.quads.quads.size() == 6 * 36);
  std::size_t onCurves = 0, corners = 0;
  for (const Four<Index>& curves : extracted.quads.curves)
    for (const Index curve : curves) onCurves += curve != kNone;
  for (const Placement& place : extracted.quads.vertices)
    corners += place.kind == VertexKind::Corner;
  CHECK(onCurves == 2 * 12 * 6);
  CHECK(corners == 8);
}
