// SPDX-License-Identifier: MIT
#include "jobs/dropping.h"

#include <doctest/doctest.h>

#include "base/error.h"
#include "support/shapes.h"
#include "support/soups.h"

using namespace remesher;

namespace {

io::Part partOf(TriangleMesh mesh) { return {"", std::move(mesh), {Transform::Identity()}}; }

TriangleMesh timesSize(TriangleMesh mesh, double factor) {
  for (Vec3& p : mesh.positions) p *= factor;
  return mesh;
}

PartOptions below(double percent) {
  PartOptions options;
  options.dropBelow = percent;
  return options;
}

}  // namespace

TEST_CASE("dropping: small pieces go, and all others stay bit for bit") {
  const TriangleMesh ball = shapes::icosphere(4);
  const TriangleMesh speck = soups::moved(timesSize(shapes::icosphere(2), 0.01), {2, 0, 0});
  std::vector<io::Part> parts = {partOf(soups::joined({speck, ball}))};
  const Dropped dropped = dropSmallPieces(parts, below(2));
  CHECK(parts[0].mesh.positions == ball.positions);
  CHECK(parts[0].mesh.indices == ball.indices);
  CHECK(dropped.report.pieces == 1);
  REQUIRE(dropped.report.piecesAt.size() == 1);
  CHECK((dropped.report.piecesAt[0].at - Vec3(2, 0, 0)).norm() < 0.001);
  CHECK(dropped.report.piecesAt[0].across == doctest::Approx(0.034).epsilon(0.1));
  REQUIRE(dropped.warnings.size() == 1);
  CHECK(dropped.warnings[0].code == "PIECES_DROPPED");
  CHECK_THROWS_AS(dropSmallPieces(parts, below(101)), Error);
}

TEST_CASE("dropping: pieces are measured in the world, whatever its size") {
  for (const double size : {1.0, 1e-30, 1e30}) {
    std::vector<io::Part> parts = {partOf(timesSize(shapes::icosphere(3), size)),
                                   partOf(timesSize(shapes::cube(1), size))};
    parts[1].instances = {Transform(Eigen::Translation3d(3 * size, 0, 0) * Eigen::Scaling(0.01))};
    const Dropped dropped = dropSmallPieces(parts, below(1));
    CHECK(dropped.report.pieces == 1);
    CHECK(parts[1].mesh.indices.empty());
    CHECK(dropped.report.piecesAt[0].across / size == doctest::Approx(0.01 * std::sqrt(3)));
  }
}

TEST_CASE("dropping: what other parts hide goes, unless it moves or shows at another place") {
  const TriangleMesh inner = timesSize(shapes::torus(12, 6), 0.2);
  const auto given = [&] {
    return std::vector<io::Part>{partOf(shapes::icosphere(4)), partOf(inner)};
  };
  std::vector<io::Part> parts = given();
  CHECK(dropHiddenTriangles(parts, Hidden::Triangles).report.hidden == inner.triangleCount());
  CHECK(parts[1].mesh.indices.empty());
  CHECK(parts[0].mesh.indices == shapes::icosphere(4).indices);
  parts = given();
  parts[1].instances.push_back(Transform(Eigen::Translation3d(5, 0, 0)));
  CHECK(dropHiddenTriangles(parts, Hidden::Triangles).report.hidden == 0);
  parts = given();
  parts[1].mesh.attributes = {
      {"JOINTS_0", 4, std::vector<float>(4 * parts[1].mesh.positions.size(), 0)}};
  CHECK(dropHiddenTriangles(parts, Hidden::Triangles).report.hidden == 0);
}

TEST_CASE("dropping: closed pieces stay closed where that is asked for") {
  const TriangleMesh ball = shapes::icosphere(5);
  const TriangleMesh both = soups::joined({ball, soups::moved(ball, {0.9, 0.1, 0.2})});
  std::vector<io::Part> parts = {partOf(both)};
  CHECK(dropHiddenTriangles(parts, Hidden::Pieces).report.hidden == 0);
  CHECK(dropHiddenTriangles(parts, Hidden::Triangles).report.hidden > 0);
}
