// SPDX-License-Identifier: MIT
#include "jobs/open_number.h"

#include <doctest/doctest.h>

#include "measure/hausdorff.h"
#include "measure/mesh_report.h"
#include "support/parts.h"
#include "support/shapes.h"

using namespace remesher;

namespace {

constexpr double kWithin = 0.05, kWideAngle = 40;

RemeshOutcome remeshedOpenly(const TriangleMesh& mesh) {
  const RemeshOptions options;
  REQUIRE(leavesNumberOpen(options));
  return remeshAtOpenNumber(mesh, Welding(mesh), options, {});
}

bool says(const RemeshOutcome& made, const std::string& code) {
  return std::any_of(made.warnings.begin(), made.warnings.end(),
                     [&](const Warning& warning) { return warning.code == code; });
}

}  // namespace

TEST_CASE("open number: the input's own where isotropic triangles keep the shape") {
  const TriangleMesh sphere = shapes::icosphere(3);
  const RemeshOutcome made = remeshedOpenly(sphere);
  CHECK(made.vertices == sphere.positions.size());
  CHECK(made.prefer == Prefer::Even);
  CHECK(made.warnings.empty());
}

TEST_CASE("open number: of a part as many as isotropic triangles need") {
  for (const TriangleMesh& part : {shapes::filletedBar(12), shapes::drilledPlate(12, 2)}) {
    const RemeshOutcome made = remeshedOpenly(part);
    CHECK(says(made, "MORE_VERTICES_TAKEN"));
    CHECK(made.vertices > part.positions.size());
    CHECK(made.vertices <= 4 * part.positions.size());
    CHECK(inspectMesh(made.mesh).minAngle.mean >= kWideAngle);
    CHECK(measureFidelity(part, made.mesh).hausdorff <= kWithin);
  }
}

TEST_CASE("open number: where four times as many do not suffice the shape stays, with a number") {
  TriangleMesh bar = shapes::filletedBar(3);
  for (Vec3& p : bar.positions) p.x() *= 8;
  const RemeshOutcome made = remeshedOpenly(bar);
  CHECK(made.vertices == bar.positions.size());
  CHECK(measureFidelity(bar, made.mesh).hausdorff <= kWithin);
  CHECK(says(made, "ISOTROPIC_TAKES_MORE"));
}

TEST_CASE("open number: not where a number, a bound or a kind of triangles is asked for") {
  const auto isOpen = [](auto set) {
    RemeshOptions options;
    set(options);
    return leavesNumberOpen(options);
  };
  CHECK(!isOpen([](RemeshOptions& o) { o.vertices = 100; }));
  CHECK(!isOpen([](RemeshOptions& o) { o.ratio = 1; }));
  CHECK(!isOpen([](RemeshOptions& o) { o.maxError = 1; }));
  CHECK(!isOpen([](RemeshOptions& o) { o.prefer = Prefer::Shape; }));
  CHECK(!isOpen([](RemeshOptions& o) { o.scheme = Scheme::Rounds; }));
  CHECK(!isOpen([](RemeshOptions& o) { o.quads = true; }));
}
