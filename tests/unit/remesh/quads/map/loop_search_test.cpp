// SPDX-License-Identifier: MIT
#include "remesh/quads/map/loop_search.h"

#include <doctest/doctest.h>

#include <cmath>

#include "mesh/quad_loops.h"
#include "remesh/quads/extract/extraction.h"
#include "remesh/quads/mesh/quad_check.h"
#include "support/working_meshes.h"

using namespace remesher;

namespace {

// A ball with dents, of no symmetry.
TriangleMesh dentedBall() {
  TriangleMesh mesh = shapes::icosphere(8);
  for (Vec3& p : mesh.positions)
    p *= 1 + 0.15 * p.x() * p.y() + 0.2 * p.z() * p.z() * p.x() - 0.1 * p.y() * p.z();
  return mesh;
}

// The share of the longest loop, and that of the quads in which one crosses itself.
double windingOf(const QuadMesh& quads) {
  const QuadLoops loops = loopsOf(quads.quads.size(), sidesByEdge(quads.quads));
  return double(loops.longest) / double(loops.edges) +
         double(loops.selfCrossing) / double(quads.quads.size());
}

}  // namespace

TEST_CASE("loop search: other integers keep the kind, the number and the irregular vertices") {
  const OriginalSurface surface = shapes::surfaceOf(dentedBall());
  const WorkingMesh mesh(surface);
  const FaceFrames frames(mesh);
  std::size_t shorter = 0;
  for (const double length : {0.17, 0.2, 0.23}) {
    const CrossField field = makeCrossField(mesh, frames, length);
    const MapMaker maker(mesh, field, FaceData<double>(mesh.mesh().faceCapacity(), 1.0));
    const SeamlessMap start = maker.map(length).value();
    const double count = maker.countVertices(start);
    const std::vector<Eigen::VectorXd> found = maker.withShorterLoops(start, count, 0.05);
    CHECK(found == maker.withShorterLoops(start, count, 0.05));
    if (found.empty()) continue;
    const SeamlessMap map = maker.mapOf(found.front(), length).value();
    CHECK(std::abs(maker.countVertices(map) / count - 1) <= 0.05);
    const QuadMesh before = extractQuads(mesh, start), after = extractQuads(mesh, map);
    CHECK(check(after).empty());
    CHECK(kindOf(after) == kindOf(mesh.mesh()));
    CHECK(countIrregular(after.vertices.size(), sidesByEdge(after.quads)) ==
          countIrregular(before.vertices.size(), sidesByEdge(before.quads)));
    shorter += windingOf(after) < windingOf(before);
  }
  CHECK(shorter > 0);
}
