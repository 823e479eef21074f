// SPDX-License-Identifier: MIT
#include "jobs/region_run.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "base/place.h"
#include "measure/mesh_report.h"
#include "mesh/used_vertices.h"
#include "remesher.h"
#include "support/shapes.h"

using namespace remesher;

namespace {

// The triangles whose middle is above a height.
std::vector<Index> above(const TriangleMesh& mesh, double height) {
  std::vector<Index> found;
  for (Index t = 0; t < mesh.triangleCount(); ++t) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += mesh.positions[mesh.indices[3 * t + k]].z();
    if (sum / 3 > height) found.push_back(t);
  }
  return found;
}

using Coordinates = std::array<std::array<double, 3>, 3>;

std::multiset<Coordinates> trianglesBut(const TriangleMesh& mesh,
                                        const std::vector<Index>& without) {
  std::multiset<Coordinates> all;
  for (Index t = 0; t < mesh.triangleCount(); ++t) {
    if (std::find(without.begin(), without.end(), t) != without.end()) continue;
    Coordinates corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = mesh.positions[mesh.indices[3 * t + k]];
      corners[k] = {p.x(), p.y(), p.z()};
    }
    all.insert(corners);
  }
  return all;
}

TriangleMesh unitBall() {
  TriangleMesh mesh = shapes::icosphere(8);
  const std::vector<Index> first = weld(mesh.positions);
  for (Index& i : mesh.indices) i = first[i];
  keepUsedVertices(mesh);
  return mesh;
}

// An odd scale and place: coordinates that take all digits.
TriangleMesh ball() {
  TriangleMesh mesh = unitBall();
  for (Vec3& p : mesh.positions) p = 1.7 * p + Vec3(12.3, 0.1, 1e-3);
  return mesh;
}

}  // namespace

TEST_CASE("region: all other triangles stay bit for bit, and the surface stays closed") {
  const TriangleMesh mesh = ball();
  const std::size_t places = mesh.positions.size();
  for (const double factor : {0.9, 1.0, 1.6}) {
    PartOptions options;
    options.region = above(mesh, 0.4);
    options.vertices = Index(factor * double(places));
    const RemeshResult result = remesh(mesh, options);
    CHECK(result.mesh.positions.size() == *options.vertices);
    CHECK(result.report.output->vertices == *options.vertices);
    CHECK(result.report.input.vertices == places);
    CHECK(result.report.output->boundaryEdges == 0);
    CHECK(result.report.output->nonManifoldEdges == 0);
    CHECK(result.report.output->eulerCharacteristic == 2);
    const auto kept = trianglesBut(mesh, options.region);
    const auto made = trianglesBut(result.mesh, {});
    CHECK(std::includes(made.begin(), made.end(), kept.begin(), kept.end()));
  }
}

TEST_CASE("region: a border with noise around zero is closed again") {
  TriangleMesh mesh = unitBall();
  std::size_t noisy = 0;
  for (Vec3& p : mesh.positions)
    if (std::abs(p.z()) < 1e-9) p.z() = ++noisy % 2 == 0 ? 1e-19 : -1e-19;
  REQUIRE(noisy > 0);
  PartOptions options;
  options.region = above(mesh, 0);
  options.ratio = 1;
  const RemeshResult result = remesh(mesh, options);
  CHECK(result.mesh.positions.size() == mesh.positions.size());
  CHECK(inspectMesh(result.mesh).boundaryEdges == 0);
}

TEST_CASE("region: with as many vertices as before the others keep their numbers") {
  const TriangleMesh mesh = ball();
  PartOptions options;
  options.region = above(mesh, 0.4);
  options.ratio = 1.5;
  const RemeshResult result = remesh(mesh, options);
  std::vector<char> isInside(mesh.triangleCount(), 0);
  for (const Index t : options.region) isInside[t] = 1;
  for (std::size_t t = 0; t < isInside.size(); ++t)
    for (std::size_t k = 3 * t; !isInside[t] && k < 3 * t + 3; ++k) {
      REQUIRE(result.mesh.indices[k] == mesh.indices[k]);
      REQUIRE(result.mesh.positions[mesh.indices[k]] == mesh.positions[mesh.indices[k]]);
    }
}

TEST_CASE("region: attributes outside and along the border stay, also where a seam crosses it") {
  TriangleMesh mesh = shapes::grid(8, 8);
  const auto vertices = Index(mesh.positions.size());
  Attribute uv{"TEXCOORD_0", 2, {}};
  for (const Vec3& p : mesh.positions)
    uv.values.insert(uv.values.end(), {float(p.x()), float(p.y())});
  // A second copy of all vertices with other coordinates, for the triangles of one side.
  mesh.positions.insert(mesh.positions.end(), mesh.positions.begin(), mesh.positions.end());
  for (std::size_t i = 0; i < 2 * std::size_t(vertices); ++i) uv.values.push_back(uv.values[i] + 5);
  mesh.attributes = {uv};
  const Vec3 low = mesh.positions.front(), high = mesh.positions[vertices - 1];
  std::vector<Index> region;
  for (Index t = 0; t < mesh.triangleCount(); ++t) {
    Vec3 middle = Vec3::Zero();
    for (std::size_t k = 0; k < 3; ++k) middle += mesh.positions[mesh.indices[3 * t + k]] / 3;
    const Vec3 share = (middle - low).cwiseQuotient((high - low) + Vec3(0, 0, 1));
    if (share.x() > 0.5)
      for (std::size_t k = 0; k < 3; ++k) mesh.indices[3 * t + k] += vertices;
    if (share.y() > 0.5) region.push_back(t);
  }
  PartOptions options;
  options.region = region;
  options.edgeLength = 0.6 * shapes::meanEdge(mesh);
  const RemeshResult result = remesh(mesh, options);
  REQUIRE(result.mesh.attributes.size() == 1);
  const auto& made = result.mesh.attributes.front().values;
  for (Index v = 0; v < result.mesh.positions.size(); ++v) {
    const Vec3& p = result.mesh.positions[v];
    const bool isFirst = std::abs(made[2 * v] - float(p.x())) < 1e-4;
    CHECK((isFirst || std::abs(made[2 * v] - 5 - float(p.x())) < 1e-4));
  }
  CHECK(inspectMesh(result.mesh).boundaryEdges > 0);
  CHECK(inspectMesh(result.mesh).eulerCharacteristic == 1);
}

TEST_CASE("region: what cannot be is refused with the numbers of the whole") {
  const TriangleMesh mesh = ball();
  const auto refusal = [&](auto change) {
    PartOptions options;
    options.region = above(mesh, 0.4);
    change(options);
    try {
      remesh(mesh, options);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(refusal([](PartOptions& o) { o.region = {9999}; }).find("triangle 9999") !=
        std::string::npos);
  CHECK(refusal([](PartOptions& o) { o.vertices = 20; }).find("outside the region there are") !=
        std::string::npos);
  CHECK(refusal([](PartOptions& o) { o.repair = Repair::Auto; }).find("bit for bit") !=
        std::string::npos);
}
