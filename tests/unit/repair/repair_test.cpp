// SPDX-License-Identifier: MIT
#include "repair/repair.h"

#include <doctest/doctest.h>

#include "measure/mesh_report.h"
#include "support/hostile_shapes.h"
#include "support/shapes.h"
#include "support/soups.h"

using namespace remesher;

namespace {

RepairedMesh mended(const TriangleMesh& mesh) {
  RemeshOptions options;
  options.repair = Repair::Auto;
  options.edgeLength = 1;  // so that the lattice is the coarsest that there is
  return repairSurface(mesh, options);
}

}  // namespace

TEST_CASE("repair: auto does no harm to what is whole") {
  for (const TriangleMesh& mesh : {shapes::icosphere(3), shapes::torus(10, 5), shapes::cube(2)}) {
    const RepairedMesh result = mended(mesh);
    CHECK(result.report.mode == "holes");
    CHECK(result.mesh.positions == mesh.positions);
    CHECK(result.mesh.indices == mesh.indices);
    CHECK(result.warnings.empty());
  }
}

TEST_CASE("repair: auto closes holes where that is enough") {
  TriangleMesh open = shapes::icosphere(4);
  open.indices.resize(open.indices.size() - 9);
  const RepairedMesh result = mended(open);
  CHECK(result.report.mode == "holes");
  CHECK(result.report.holes >= 1);
}

TEST_CASE("repair: auto unites bodies, and turns those that are inside out") {
  const TriangleMesh ball = shapes::icosphere(3);
  for (const TriangleMesh& mesh :
       {soups::joined({ball, soups::moved(ball, {0.7, 0.1, 0.2})}), shapes::turnedOver(ball)}) {
    const RepairedMesh result = mended(mesh);
    CHECK(result.report.mode == "solid");
    CHECK(result.report.selfIntersections[1] == 0);
    CHECK(inspectMesh(result.mesh).eulerCharacteristic == 2);
  }
}

TEST_CASE("repair: auto wraps a sheet, and loose triangles") {
  for (const TriangleMesh& mesh : {shapes::grid(3, 2), soups::randomSoup(40, 0.3, 3)}) {
    const RepairedMesh result = mended(mesh);
    CHECK(result.report.mode == "wrap");
    CHECK(result.report.selfIntersections[1] == 0);
    CHECK(inspectMesh(result.mesh).boundaryEdges == 0);
  }
}
