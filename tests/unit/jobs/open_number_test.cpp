// SPDX-License-Identifier: MIT
#include "jobs/open_number.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "measure/hausdorff.h"
#include "measure/mesh_report.h"
#include "support/parts.h"
#include "support/shapes.h"

using namespace remesher;

namespace {

constexpr double kWithin = 0.05, kWideAngle = 40;

RemeshOutcome remeshedOpenly(const TriangleMesh& mesh) {
  const PartOptions options;
  REQUIRE(leavesNumberOpen(options));
  return remeshAtOpenNumber(mesh, Welding(mesh), options, {});
}

bool isIsotropicOf(const TriangleMesh& input, const RemeshOutcome& made) {
  return inspectMesh(made.mesh).minAngle.mean >= kWideAngle &&
         measureFidelity(input, made.mesh).hausdorff <= kWithin;
}

bool says(const RemeshOutcome& made, const std::string& code) {
  return std::any_of(made.warnings.begin(), made.warnings.end(),
                     [&](const Warning& warning) { return warning.code == code; });
}

}  // namespace

TEST_CASE("open number: the input's own where isotropic triangles keep the shape") {
  const TriangleMesh sphere = shapes::icosphere(3);
  const RemeshOutcome made = remeshedOpenly(sphere);
  CHECK(made.vertices == inspectMesh(sphere).vertices);
  CHECK(made.prefer == Prefer::Even);
  CHECK(made.warnings.empty());
  CHECK(made.chosen.rule != "more-vertices");
}

TEST_CASE("open number: of a part as many as isotropic triangles need") {
  for (const TriangleMesh& part : {shapes::drilledPlate(3, 2), shapes::drilledPlate(8, 0.5)}) {
    const RemeshOutcome made = remeshedOpenly(part);
    CHECK(says(made, "MORE_VERTICES_TAKEN"));
    CHECK(made.chosen.rule == "more-vertices");
    CHECK(made.vertices > part.positions.size());
    CHECK(made.vertices <= 4 * part.positions.size());
    CHECK(isIsotropicOf(part, made));
  }
}

TEST_CASE("open number: triangles that are even already stay as many as they are") {
  // Two squares side by side and a fin on their common edge, all halves of squares.
  TriangleMesh sheet;
  sheet.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}, {1, 0, 1}};
  sheet.indices = {0, 1, 2, 0, 2, 3, 1, 4, 5, 1, 5, 2, 1, 2, 6};
  const RemeshOutcome made = remeshedOpenly(sheet);
  CHECK(!says(made, "MORE_VERTICES_TAKEN"));
  CHECK(!says(made, "ISOTROPIC_TAKES_MORE"));
}

TEST_CASE("open number: where four times as many do not suffice the shape stays, with a number") {
  const TriangleMesh block = shapes::drilledPlate(6, 2);
  const RemeshOutcome made = remeshedOpenly(block);
  CHECK(made.vertices == block.positions.size());
  CHECK(measureFidelity(block, made.mesh).hausdorff <= kWithin);
  REQUIRE(says(made, "ISOTROPIC_TAKES_MORE"));
  CHECK(made.chosen.rule == "own-number");
  const std::string& message = made.warnings.front().message;
  PartOptions options;
  options.vertices = Index(std::stoul(message.substr(message.find("about ") + 6)));
  CHECK(*options.vertices > 4 * made.vertices);
  CHECK(isIsotropicOf(block, remeshSurface(block, Welding(block), options, {})));
}

TEST_CASE("open number: not where a number, a bound or a kind of triangles is asked for") {
  const auto isOpen = [](auto set) {
    PartOptions options;
    set(options);
    return leavesNumberOpen(options);
  };
  CHECK(!isOpen([](PartOptions& o) { o.vertices = 100; }));
  CHECK(!isOpen([](PartOptions& o) { o.ratio = 1; }));
  CHECK(!isOpen([](PartOptions& o) { o.maxError = 1; }));
  CHECK(!isOpen([](PartOptions& o) { o.prefer = Prefer::Shape; }));
  CHECK(!isOpen([](PartOptions& o) { o.scheme = Scheme::Rounds; }));
  CHECK(!isOpen([](PartOptions& o) { o.quads = true; }));
}
