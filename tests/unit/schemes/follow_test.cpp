// SPDX-License-Identifier: MIT
#include "schemes/follow.h"

#include <doctest/doctest.h>

#include "measure/hausdorff.h"
#include "measure/mesh_report.h"
#include "schemes/remesh.h"
#include "support/working_meshes.h"

using namespace remesher;

namespace {

// A pleated sheet whose pleats are narrower than an even triangle of 150 vertices.
TriangleMesh pleats() {
  TriangleMesh mesh = shapes::grid(40, 32);
  for (Vec3& p : mesh.positions) {
    const bool isHigh = std::lround(p.x()) % 2 != 0;
    p = {p.x() / 2, p.y() / 8, isHigh ? 0.1 : 0.0};
  }
  return mesh;
}

TriangleMesh remeshed(const TriangleMesh& input, Index vertices, Textures textures) {
  RemeshOptions options;
  options.vertices = vertices;
  options.textures = textures;
  return remeshSurface(input, options, {}).mesh;
}

double rms(const TriangleMesh& original, const TriangleMesh& result) {
  const DeviationBothWays d = measureDeviation(original, result, Maximum::Sampled);
  return std::max(d.toResult.rms, d.toOriginal.rms) / d.diagonal;
}

}  // namespace

TEST_CASE("follow: exactly as many places as asked for, or nothing") {
  const OriginalSurface surface = shapes::surfaceOf(pleats());
  for (const std::size_t count : {1000, 500, 150}) {
    const std::optional<WorkingMesh> mesh = follow(surface, {}, count);
    REQUIRE(mesh);
    CHECK(distinctPositions(*mesh) == count);
    CHECK(shapes::checkWorkingMesh(*mesh) == "");
  }
  CHECK(!follow(surface, {}, 4));
  // Nothing is left out of what has no more.
  CHECK(!follow(surface, {}, surface.mesh().vertexCount()));
}

TEST_CASE("follow: pleats narrower than even triangles are kept where textures are painted anew") {
  const TriangleMesh original = pleats();
  const double even = rms(original, remeshed(original, 150, Textures::Keep));
  const double followed = rms(original, remeshed(original, 150, Textures::Bake));
  CHECK(even > 0.001);
  CHECK(followed < 0.1 * even);
}

TEST_CASE("follow: what even triangles show has even triangles") {
  for (const TriangleMesh& original : {shapes::icosphere(16), shapes::torus(64, 32)}) {
    const TriangleMesh result = remeshed(original, 600, Textures::Bake);
    CHECK(inspectMesh(result).minAngle.mean > 52);
  }
}
