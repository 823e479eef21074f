// SPDX-License-Identifier: MIT
#include "remesh/quads/map/untangle.h"

#include <doctest/doctest.h>

#include <Eigen/SparseCholesky>

#include "remesh/quads/field/singularities.h"
#include "support/soups.h"
#include "support/working_meshes.h"

using namespace remesher;

TEST_CASE("untangle: a plane map whose inner vertices were thrown about has no fold afterwards") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::grid(8, 8));
  const WorkingMesh mesh(surface);
  const FaceFrames frames(mesh);
  const CrossField field = makeCrossField(mesh, frames, 1);
  const VertexData<int> singular = quarterIndices(field, mesh, frames);
  const CutField cut = cutOpen(mesh, field, singular);
  const SeamlessSystem system({mesh, frames, cut, singular});
  REQUIRE(system.isSolvable());
  const FaceData<double> even(mesh.mesh().faceCapacity(), 1.0);
  const auto [matrix, right] = system.quadratic(even);
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  const Eigen::VectorXd exact = solver.solve(right);
  soups::Random random(3);
  Eigen::VectorXd values = exact;
  for (Index i = 0; i < system.realCount(); ++i)
    if (random.number() < 0.05) values[i] += 3 * (random.number() - 0.5);
  CHECK(untangle(values, {mesh, frames, system, even, 1}) == 0);
  // What is to be whole stays.
  CHECK(values.tail(values.size() - system.realCount()) ==
        exact.tail(values.size() - system.realCount()));
}
