// SPDX-License-Identifier: MIT
#include "jobs/parts/part_guides.h"

#include <doctest/doctest.h>

#include "support/shapes.h"

using namespace remesher;

namespace {

io::Part partAt(const Vec3& where) {
  io::Part part;
  part.mesh = shapes::icosphere(4);
  part.instances = {Transform(Eigen::Translation3d(where))};
  return part;
}

}  // namespace

TEST_CASE("part guides: each goes to the nearest place, in that part's own space") {
  std::vector<io::Part> parts = {partAt({0, 0, 0}), partAt({10, 0, 0})};
  parts[0].instances.push_back(Transform(Eigen::Translation3d(0, 20, 0)));
  PartOptions options;
  options.quads = true;
  options.guides = {{{{10, 0, 1}, {11, 0, 0}}, GuideKind::Direction, false, "arc"},
                    {{{0, 20, 1}, {1, 20, 0}}, GuideKind::Direction, false, "copy"}};
  const SharedGuides shared = sharedGuides(parts, options);
  REQUIRE(shared.ofSurface.size() == 2);
  REQUIRE(shared.ofSurface[1].size() == 1);
  CHECK(shared.ofSurface[1][0].points[1].isApprox(Vec3(1, 0, 0)));
  REQUIRE(shared.ofSurface[0].size() == 1);
  CHECK(shared.ofSurface[0][0].points[0].isApprox(Vec3(0, 0, 1)));
  CHECK(shared.warnings.empty());
}

TEST_CASE("part guides: what is far away is named, with its distance") {
  PartOptions options;
  options.quads = true;
  options.guides = {{{{0, 0, 3}, {1, 0, 3}}, GuideKind::Direction, false, "cloud"}};
  const SharedGuides shared = sharedGuides({partAt({0, 0, 0})}, options);
  REQUIRE(shared.warnings.size() == 1);
  CHECK(shared.warnings[0].code == "GUIDES_FAR_AWAY");
  CHECK(shared.warnings[0].message.find("cloud (by ") != std::string::npos);
}
