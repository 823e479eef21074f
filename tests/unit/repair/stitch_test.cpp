// SPDX-License-Identifier: MIT
#include "repair/stitch.h"

#include <doctest/doctest.h>

#include "measure/mesh_report.h"
#include "measure/self_intersections.h"
#include "support/shapes.h"
#include "support/soups.h"

using namespace remesher;

namespace {

// Every triangle with corners of its own, each moved by up to `noise` along each axis.
TriangleMesh apart(const TriangleMesh& mesh, double noise) {
  TriangleMesh result;
  unsigned state = 1;
  for (const Index v : mesh.indices) {
    Vec3 p = mesh.positions[v];
    for (double& x : p) {
      state = state * 1664525u + 1013904223u;
      x += noise * (double(state >> 8) / (1 << 23) - 1);
    }
    result.indices.push_back(Index(result.positions.size()));
    result.positions.push_back(p);
  }
  return result;
}

// A box whose sides have different numbers of rows, so that vertices lie within edges.
TriangleMesh boxWithJunctions() {
  TriangleMesh box;
  const auto side = [&](const Vec3& corner, const Vec3& u, const Vec3& v, int n) {
    shapes::addSheet(box, n, n, [&](int i, int j) {
      return Vec3(corner + double(i) / n * u + double(j) / n * v);
    });
  };
  const Vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1), o(0, 0, 0);
  side(o, y, x, 2), side(z, x, y, 4), side(o, x, z, 1), side(y, z, x, 8), side(o, z, y, 4),
      side(x, y, z, 2);
  return box;
}

}  // namespace

TEST_CASE("stitch: corners that differ by little become one, at the smallest distance that does") {
  for (const double noise : {1e-8, 1e-7, 1e-6, 1e-5}) {
    TriangleMesh mesh = apart(shapes::cube(2), noise);
    CHECK(countUnbalancedEdges(mesh) > 0);
    weldOpenVertices(mesh);
    CHECK(countUnbalancedEdges(mesh) == 0);
    CHECK(inspectMesh(mesh).eulerCharacteristic == 2);
  }
}

TEST_CASE("stitch: a wide crack is closed if hardly anything else is open") {
  const TriangleMesh ball = shapes::icosphere(8);
  const auto parted = [&](double width, double openBelow) {
    TriangleMesh mesh = ball;
    mesh.indices.clear();
    for (std::size_t i = 0; i < ball.indices.size(); i += 3) {
      double middle = 0, low = 1;
      for (std::size_t k = 0; k < 3; ++k) {
        const double z = ball.positions[ball.indices[i + k]].z();
        middle += z, low = std::min(low, z);
      }
      if (low < openBelow) continue;
      const Vec3 by(0, 0, middle > 0.3 ? width : 0);
      for (std::size_t k = 0; k < 3; ++k) {
        mesh.indices.push_back(Index(mesh.positions.size()));
        mesh.positions.push_back(ball.positions[ball.indices[i + k]] + by);
      }
    }
    return mesh;
  };
  const auto isClosedAfter = [&](TriangleMesh mesh) {
    const std::size_t before = countUnbalancedEdges(mesh);
    CHECK(before > 0);
    closeWideCracks(mesh);
    return countUnbalancedEdges(mesh) == 0;
  };
  CHECK(isClosedAfter(parted(2e-3, -2)));
  CHECK(!isClosedAfter(parted(2e-2, -2)));
  TriangleMesh bowl = parted(2e-3, -0.5);
  const TriangleMesh before = bowl;
  closeWideCracks(bowl);
  CHECK(bowl.positions == before.positions);
  TriangleMesh box = apart(boxWithJunctions(), 3e-4);
  CHECK(isClosedAfter(box));
}

TEST_CASE("stitch: vertices of closed surfaces stay where they are") {
  TriangleMesh mesh = shapes::icosphere(4);
  mesh.positions.push_back(mesh.positions[0] + Vec3(1e-7, 0, 0));
  const TriangleMesh before = mesh;
  weldOpenVertices(mesh);
  CHECK(mesh.positions == before.positions);
}

TEST_CASE("stitch: T-junctions are closed exactly, with the attributes along the edge") {
  TriangleMesh mesh = boxWithJunctions();
  Attribute where{"TEXCOORD_0", 2, {}};
  for (const Vec3& p : mesh.positions)
    where.values.insert(where.values.end(), {float(p.x() + 2 * p.y()), float(p.z())});
  mesh.attributes = {where};
  const std::size_t before = mesh.triangleCount();
  CHECK(countUnbalancedEdges(mesh) > 0);
  const std::vector<Index> inputs = stitchOpenEdges(mesh);
  CHECK(inputs.size() == mesh.triangleCount());
  CHECK(mesh.triangleCount() > before);
  CHECK(countUnbalancedEdges(mesh) == 0);
  CHECK(selfIntersections(mesh).empty());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Vec3& p = mesh.positions[v];
    CHECK(mesh.attributes[0].values[2 * v] == doctest::Approx(p.x() + 2 * p.y()));
    CHECK(mesh.attributes[0].values[2 * v + 1] == doctest::Approx(p.z()));
  }
}
