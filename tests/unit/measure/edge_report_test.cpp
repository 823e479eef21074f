// SPDX-License-Identifier: MIT
#include "measure/edge_report.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "support/soups.h"

using namespace remesher;

namespace {

EdgeReport edgesOf(const TriangleMesh& mesh) { return reportEdges(mesh, Welding(mesh)); }

}  // namespace

TEST_CASE("edge_report: twelve edges of a cube bend by a right angle, its diagonals not at all") {
  const EdgeReport report = edgesOf(soups::cube(-1, 1));
  CHECK(report.boundary.empty());
  CHECK(report.nonManifold.empty());
  CHECK(report.flipped.empty());
  REQUIRE(report.bent.size() == 2 * 12);
  for (const double bend : report.bends) CHECK(bend == doctest::Approx(90));
}

TEST_CASE("edge_report: the outline of an open square is its border") {
  const EdgeReport report = edgesOf(soups::square(7));
  CHECK(report.boundary.size() == 2 * 28);
  CHECK(report.bent.empty());
}

TEST_CASE("edge_report: bends come sharpest first, of one vertex at each place") {
  TriangleMesh mesh = soups::cube(-1, 1);
  for (Vec3& p : mesh.positions)
    if (p.z() > 0) p.head<2>() /= 4;
  const EdgeReport report = edgesOf(mesh);
  CHECK(std::is_sorted(report.bends.rbegin(), report.bends.rend()));
  CHECK(report.bends.front() > 90);
  for (const Index v : report.bent) CHECK(report.first[v] == v);
}

TEST_CASE("edge_report: a third triangle, and one that faces the other way, are reported") {
  TriangleMesh fan;
  soups::addTriangle(fan, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  soups::addTriangle(fan, {0, 0, 0}, {1, 0, 0}, {0, -1, 0});
  const EdgeReport two = edgesOf(fan);
  CHECK(two.flipped.size() == 2);
  CHECK(two.boundary.size() == 2 * 4);
  soups::addTriangle(fan, {0, 0, 0}, {1, 0, 0}, {0, 0, 1});
  const EdgeReport three = edgesOf(fan);
  CHECK(three.flipped.empty());
  CHECK(three.nonManifold.size() == 2);
  CHECK(three.boundary.size() == 2 * 6);
}
