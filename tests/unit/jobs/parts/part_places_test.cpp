// SPDX-License-Identifier: MIT
#include "jobs/parts/part_places.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/part_options.h"
#include "measure/hausdorff.h"
#include "measure/mesh_report.h"
#include "remesher.h"
#include "support/area_of.h"
#include "support/shapes.h"

using namespace remesher;

namespace {

Transform scaling(double x, double y, double z) { return Transform(Eigen::Scaling(Vec3(x, y, z))); }

Transform turned(double degrees) {
  Transform transform = Transform::Identity();
  transform.rotate(Eigen::AngleAxisd(degrees * std::numbers::pi / 180, Vec3(1, 2, 3).normalized()));
  return transform;
}

TriangleMesh placed(TriangleMesh mesh, const Transform& place) {
  for (Vec3& p : mesh.positions) p = place * p;
  return mesh;
}

TriangleMesh singled(TriangleMesh mesh) {
  for (Vec3& p : mesh.positions) p = inSingle(p, {});
  mesh.isSingle = true;
  return mesh;
}

}  // namespace

TEST_CASE("part places: a flat part's area is that of what is shown, however it is scaled") {
  const TriangleMesh grid = shapes::grid(5, 3);
  for (const Transform& place : {scaling(20, 1, 1), Transform(turned(40) * scaling(3, 0.2, 7))}) {
    const std::vector<io::Part> parts = {io::Part{"", grid, {place}}};
    CHECK(placesOf(parts)[0].area == doctest::Approx(shapes::areaOf(placed(grid, place))));
  }
}

TEST_CASE("part places: the place that shows most counts, the first of those alike") {
  const TriangleMesh ball = shapes::icosphere(2);
  const std::vector<Transform> places = {scaling(1, 1, 1), scaling(0, 0, 0), scaling(1, 5, 1),
                                         Transform(turned(90) * scaling(1, 5, 1))};
  const PartPlace best = placesOf({io::Part{"", ball, places}})[0];
  CHECK(best.toWorld.matrix() == places[2].matrix());
}

TEST_CASE("part places: only what stretches directions unevenly changes a part") {
  CHECK(!stretchAt(scaling(3, 3, 3)));
  CHECK(!stretchAt(Transform(turned(33) * scaling(-2, -2, -2))));
  CHECK(!stretchAt(scaling(1, 0, 1)));
  CHECK(!stretchAt(scaling(0, 0, 0)));
  const Transform place(turned(25) * scaling(20, 1, -1) * turned(50));
  const auto stretch = stretchAt(place);
  REQUIRE(stretch);
  CHECK(stretch->determinant() == doctest::Approx(1));
  // What is left of the transform is a turn and a size.
  const Eigen::Matrix3d rest = place.linear() * stretch->inverse();
  const Eigen::Matrix3d squares = rest.transpose() * rest;
  CHECK((squares / squares(0, 0)).isIdentity(1e-9));
}

TEST_CASE("part places: stretching and back leaves vertices where they were, to the last digit") {
  const TriangleMesh mesh = singled(placed(shapes::torus(12, 8), turned(12)));
  for (const Transform& place : {scaling(20, 1, 0.3), Transform(turned(25) * scaling(9, 1, 2))}) {
    const Eigen::Matrix3d stretch = *stretchAt(Transform(place * turned(70)));
    CHECK(relaxed(stretched(mesh, stretch), stretch, mesh).positions == mesh.positions);
  }
}

TEST_CASE(
    "part places: other places show lengths longer only where they stretch other directions") {
  const auto elsewhere = [](const std::vector<Transform>& places) {
    return placesOf({io::Part{"", shapes::icosphere(2), places}})[0].elsewhere;
  };
  const Transform turn = turned(40);
  CHECK(elsewhere({scaling(1, 1, 1), Transform(turn * scaling(3, -3, 3)), scaling(2, 2, 2)}) == 1);
  CHECK(elsewhere({scaling(1, 5, 1), Transform(turn * scaling(1, 5, 1))}) == 1);
  CHECK(elsewhere({scaling(1, 1, 1), scaling(1, 0.1, 3)}) == doctest::Approx(10));
  CHECK(elsewhere({turn, Transform(turn * scaling(1, 0.1, 3)), scaling(0, 2, 0)}) ==
        doctest::Approx(20));
  CHECK(longestOf({"", shapes::icosphere(1), {Transform(turn * scaling(1, 0.1, 3)), turn}}) ==
        doctest::Approx(3));
}

TEST_CASE("part places: the bound and the distance said hold at every place, however stretched") {
  const TriangleMesh torus = singled(shapes::torus(24, 16));
  const std::vector<Transform> places = {scaling(1, 1, 1), scaling(-1, 1, 1), scaling(1, 3, 0.1),
                                         Transform(turned(50) * scaling(0.2, 1, 2))};
  const auto farthest = [&](const TriangleMesh& result) {
    double most = 0;
    for (const Transform& place : places) {
      const DeviationBothWays d =
          measureDeviation(placed(torus, place), placed(result, place), Maximum::Sampled);
      most = std::max({most, d.toResult.maximum, d.toOriginal.maximum});
    }
    return most;
  };
  const auto said = [](const Report& report) {
    return report.fidelity->hausdorff / 100 * report.input.diagonal * 1.001;
  };
  PartOptions options;
  options.vertices = 200;
  const RemeshSceneResult plain = remeshScene({{torus, places}}, options, {});
  CHECK(farthest(plain.meshes[0]) <= said(plain.report));
  options.vertices.reset();
  options.lengths.maxError = 0.05;
  const RemeshSceneResult bounded = remeshScene({{torus, places}}, options, {});
  CHECK(farthest(bounded.meshes[0]) <= 0.05 * 1.001);
  CHECK(farthest(bounded.meshes[0]) <= said(bounded.report));
}

TEST_CASE("part places: triangles are even where the part is shown, and the report is of that") {
  const TriangleMesh ball = singled(shapes::icosphere(3));
  for (const Transform& place : {scaling(20, 1, 1), Transform(turned(40) * scaling(0.2, 1, 3))}) {
    PartOptions options;
    options.vertices = 400;
    const RemeshSceneResult result = remeshScene({{ball, {place}}}, options, {});
    const TriangleMesh shown = placed(result.meshes[0], place);
    const MeshReport seen = inspectMesh(shown);
    CHECK(seen.minAngle.mean == doctest::Approx(result.report.output->minAngle.mean).epsilon(1e-6));
    CHECK(seen.minAngle.worst ==
          doctest::Approx(result.report.output->minAngle.worst).epsilon(1e-4));
    CHECK(seen.minAngle.mean > 49);
    CHECK(seen.vertices == 400);
  }
}
