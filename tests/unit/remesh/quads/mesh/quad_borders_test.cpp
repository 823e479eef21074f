// SPDX-License-Identifier: MIT
#include "remesh/quads/mesh/quad_borders.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "geometry/triangle.h"
#include "mesh/welding.h"
#include "remesh/schemes/remesh.h"
#include "support/working_meshes.h"

using namespace remesher;

namespace {

// A square of side 2 with a round hole of so many edges.
TriangleMesh plate(const Vec3& middle, double radius, int edges) {
  TriangleMesh mesh;
  constexpr int kRings = 10;
  shapes::addSheet(mesh, edges, kRings, [&](int x, int y) {
    const Vec3 way = shapes::onCircle(x, edges);
    const double t = double(y) / kRings;
    return Vec3((1 - t) * (middle + radius * way) + t * way / way.cwiseAbs().maxCoeff());
  });
  return mesh;
}

// The ends of the edges of one triangle, two each.
std::vector<Vec3> openEdges(const TriangleMesh& mesh) {
  std::vector<Vec3> ends;
  const Welding welding(mesh);
  welding.forEachEdge([&](std::span<const Index> edge) {
    if (edge.size() != 1) return;
    ends.push_back(mesh.positions[welding.corners[edge[0]]]);
    ends.push_back(mesh.positions[welding.corners[nextCorner(edge[0])]]);
  });
  return ends;
}

double distanceTo(const std::vector<Vec3>& edges, const Vec3& p) {
  double least = kInfinity;
  for (std::size_t i = 0; i < edges.size(); i += 2) {
    const Vec3 along = edges[i + 1] - edges[i];
    const double share = std::clamp((p - edges[i]).dot(along) / along.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (edges[i] + share * along - p).norm());
  }
  return least;
}

}  // namespace

TEST_CASE("quad borders: sides that only one quad has follow the border of the original") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::grid(2, 2));
  const WorkingMesh ground(surface);
  QuadMesh mesh;
  for (Index v = 0; v < 9; ++v) mesh.vertices.push_back(ground.placement(Vertex(v)));
  CHECK(sidesOffBorder(mesh, surface).empty());
  mesh.quads = {{0, 1, 4, 3}};  // vertex 4 is in the middle
  mesh.curves = {{0, kNone, kNone, 0}};
  CHECK(sidesOffBorder(mesh, surface) == std::vector<Index>{1, 2});
}

TEST_CASE("quad borders: around holes of all sizes no quad is missing, at any number") {
  PartOptions options;
  options.quads = true;
  const TriangleMesh middle = plate(Vec3::Zero(), 0.32, 64),
                     wide = plate(Vec3(0.2, 0.13, 0), 0.32, 60),
                     small = plate(Vec3(0.2, 0.13, 0), 0.08, 40),
                     tiny = plate(Vec3(0.3, -0.2, 0), 0.02, 40);
  using Wanted = std::vector<std::pair<const TriangleMesh*, std::vector<Index>>>;
  for (const auto& wanted :
       Wanted{{&middle, {60, 250}}, {&wide, {120}}, {&small, {60, 250}}, {&tiny, {120}}})
    for (const Index vertices : wanted.second) {
      const TriangleMesh& sheet = *wanted.first;
      CAPTURE(sheet.positions.front());
      CAPTURE(vertices);
      options.vertices = vertices;
      const RemeshOutcome made = remeshSurface(sheet, options, {});
      const std::vector<Vec3> border = openEdges(sheet), edges = openEdges(made.mesh);
      double farthest = 0, hole = 0, given = 0;
      for (const Vec3& p : edges) farthest = std::max(farthest, distanceTo(border, p));
      CHECK(farthest < 1e-6);
      const auto isOfHole = [](const Vec3& p) { return p.cwiseAbs().maxCoeff() < 0.9; };
      for (std::size_t i = 0; i < edges.size(); i += 2)
        if (isOfHole(edges[i])) hole += (edges[i + 1] - edges[i]).norm();
      for (std::size_t i = 0; i < border.size(); i += 2)
        if (isOfHole(border[i])) given += (border[i + 1] - border[i]).norm();
      // Four corners on a circle have nine tenths of its length.
      CHECK(hole > 0.8 * given);
      CHECK(hole < 1.001 * given);
    }
}
