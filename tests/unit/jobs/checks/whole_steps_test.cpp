// SPDX-License-Identifier: MIT
// Whole steps are kept where they keep the shape.
#include "jobs/checks/whole_steps.h"

#include <doctest/doctest.h>

#include "jobs/checks/precision.h"
#include "support/shapes.h"

using namespace remesher;

namespace {

const WholeSteps kShorts{1, -32768, 32767};

void addTriangleAt(TriangleMesh& mesh, double z) {
  for (const Vec3& p : {Vec3(0, 0, z), Vec3(1000, 0, z), Vec3(0, 1000, z)}) {
    mesh.indices.push_back(Index(mesh.positions.size()));
    mesh.positions.push_back(p);
  }
}

}  // namespace

TEST_CASE("whole_steps: what lies apart does not fall together") {
  TriangleMesh mesh;
  addTriangleAt(mesh, 0);
  addTriangleAt(mesh, 1);
  CHECK(inWholeSteps(mesh, kShorts));
  addTriangleAt(mesh, 0);  // copies are no others
  CHECK(inWholeSteps(mesh, kShorts));
  addTriangleAt(mesh, 0.4);
  CHECK(!inWholeSteps(mesh, kShorts));
}

TEST_CASE("whole_steps: none for short edges, nor beyond the range") {
  TriangleMesh mesh;
  addTriangleAt(mesh, 0.3);
  CHECK(inWholeSteps(mesh, kShorts)->front() == Vec3::Zero());
  CHECK(!inWholeSteps(mesh, {0.05, -32768, 32767}));
  CHECK(!inWholeSteps(mesh, {1, 0, 999}));
  CHECK(!inWholeSteps(mesh, {1, 1, 65535}));
}

TEST_CASE("whole_steps: a result comes back in them, as they will be read") {
  TriangleMesh original;
  addTriangleAt(original, 0);
  original.steps = WholeSteps{32767, -32767, 32767};
  original.isSingle = true;
  TriangleMesh result = original;
  for (Vec3& p : result.positions) p = (p + Vec3(0.3, 0.3, 0.3)) / 3000;
  const TriangleMesh rounded = inPrecisionOf(original, result).mesh;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 whole = (result.positions[i] * 32767).array().round();
    for (int k = 0; k < 3; ++k)
      CHECK(rounded.positions[i][k] == static_cast<float>(whole[k]) / 32767.0F);
  }
  original.steps.reset();
  CHECK((inPrecisionOf(original, result).mesh.positions[0] - result.positions[0]).norm() < 1e-7);
}
