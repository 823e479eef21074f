// SPDX-License-Identifier: MIT
#include "remesh/quads/shape/rewiring.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>

#include "geometry/mesh_tree.h"
#include "original/surface/surface_walk.h"
#include "remesh/quads/mesh/quad_check.h"
#include "remesh/quads/mesh/quad_parts.h"
#include "remesh/quads/shape/quad_star.h"
#include "support/working_meshes.h"

using namespace remesher;

namespace {

constexpr Index kWide = 7;

// A grid of quads on the vertices of a grid of triangles.
QuadMesh quadsOn(const WorkingMesh& ground) {
  QuadMesh mesh;
  for (Index v = 0; v < ground.mesh().vertexCapacity(); ++v)
    mesh.vertices.push_back(ground.placement(Vertex(v)));
  const auto at = [&](double x, double y) {
    for (Index v = 0; v < mesh.vertices.size(); ++v)
      if ((mesh.position(v) - Vec3(x, y, 0)).norm() < 1e-9) return v;
    return kNone;
  };
  for (Index y = 0; y + 1 < kWide; ++y)
    for (Index x = 0; x + 1 < kWide; ++x) {
      mesh.quads.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)});
      mesh.curves.push_back({kNone, kNone, kNone, kNone});
    }
  return mesh;
}

double worstOf(QuadMesh& mesh, const WorkingMesh& ground) {
  const MovingQuads moving(mesh, ground);
  double least = 1;
  for (Index q = 0; q < mesh.quads.size(); ++q) least = std::min(least, moving.quality(q));
  return least;
}

// Rewires what is unsound, and checks that no quad is worse than `least` then, and the kind kept.
void checkRewired(QuadMesh& mesh, const WorkingMesh& ground, double least) {
  REQUIRE(check(mesh) == "");
  REQUIRE(worstOf(mesh, ground) < kLeastSine);
  const SurfaceKind kind = kindOf(mesh);
  WorkBudget work;
  rewire(mesh, ground, work);
  CHECK(worstOf(mesh, ground) >= least);
  CHECK(check(mesh) == "");
  CHECK(kindOf(mesh) == kind);
}

// Wires a quad and the one after it along another diagonal of their hexagon; two corners of it may
// not give way.
void turnWrong(QuadMesh& mesh, Index one) {
  const Index two = one + 1;
  const auto [a, b, c, d] = mesh.quads[one];
  const Index e = mesh.quads[two][1], f = mesh.quads[two][2];
  REQUIRE(mesh.quads[two][0] == b);
  mesh.quads[one] = {a, f, c, d};
  mesh.quads[two] = {a, b, e, f};
  for (const Index v : {b, c}) mesh.vertices[v].kind = VertexKind::Corner;
}

// Moves two opposite corners of a quad of a grid so far from its diagonal, and holds all four.
void narrow(QuadMesh& mesh, Index quad, double above, double below) {
  const auto [a, b, c, d] = mesh.quads[quad];
  const Vec3 middle = (mesh.position(a) + mesh.position(c)) / 2;
  const Vec3 up = Vec3(-1, 1, 0).normalized();
  mesh.vertices[b].position = middle - below * up;
  mesh.vertices[d].position = middle + above * up;
  for (const Index v : {a, b, c, d}) mesh.vertices[v].kind = VertexKind::Corner;
}

}  // namespace

TEST_CASE("rewiring: a quad within one that is too narrow for it goes, with the four around it") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::grid(kWide - 1, kWide - 1));
  const WorkingMesh ground(surface);
  QuadMesh mesh = quadsOn(ground);
  narrow(mesh, 14, 0.1, 0.1);
  REQUIRE(worstOf(mesh, ground) > kLeastSine);
  const std::size_t count = mesh.quads.size();
  const Four<Index> corners = mesh.quads[14];
  Four<Index> within{};
  for (std::size_t i = 0; i < 4; ++i) {
    within[i] = Index(mesh.vertices.size());
    const Vec3 p =
        (mesh.position(corners[0]) + mesh.position(corners[2])) / 4 + mesh.position(corners[i]) / 2;
    mesh.vertices.push_back(
        ground.onSurface(closestPointFrom(surface, ground.at(Vertex(corners[0])), p)));
  }
  surround(mesh, 14, within);
  checkRewired(mesh, ground, kLeastSine);
  CHECK(mesh.quads.size() == count);
}

TEST_CASE("rewiring: an edge that was turned the wrong way is turned back") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::grid(kWide - 1, kWide - 1));
  const WorkingMesh ground(surface);
  QuadMesh mesh = quadsOn(ground);
  turnWrong(mesh, 14);
  checkRewired(mesh, ground, kLeastSine);
}

TEST_CASE("rewiring: where work ends with the first unsound quad, the others stay as they are") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::grid(kWide - 1, kWide - 1));
  const WorkingMesh ground(surface);
  QuadMesh mesh = quadsOn(ground);
  turnWrong(mesh, 7);
  turnWrong(mesh, 27);
  const auto countUnsound = [&] {
    const MovingQuads moving(mesh, ground);
    std::size_t count = 0;
    for (Index q = 0; q < mesh.quads.size(); ++q) count += moving.quality(q) < kLeastSine;
    return count;
  };
  const std::size_t all = countUnsound();
  WorkBudget one(1), none(0), work;
  rewire(mesh, ground, none);
  CHECK(countUnsound() == all);
  rewire(mesh, ground, one);
  CHECK(countUnsound() > 0);
  CHECK(countUnsound() < all);
  rewire(mesh, ground, work);
  CHECK(countUnsound() == 0);
}

TEST_CASE("rewiring: a quad whose four corners are on one straight curve gets an area") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::grid(kWide - 1, kWide - 1));
  const WorkingMesh ground(surface);
  QuadMesh mesh = quadsOn(ground);
  // Three quads beside each other on the boundary: two behind a flat one take their place.
  const auto [a, b, f, e] = mesh.quads[1];
  const auto [b2, c, g, f2] = mesh.quads[2];
  const auto [c2, d, h, g2] = mesh.quads[3];
  const Index chain = mesh.vertices[b].on.chain;
  REQUIRE(chain != kNone);
  mesh.quads[1] = {a, b, c, d};
  mesh.curves[1] = {chain, chain, chain, kNone};
  mesh.quads[2] = {a, d, h, g};
  mesh.quads[3] = {a, g, f, e};
  REQUIRE(worstOf(mesh, ground) == doctest::Approx(0));
  checkRewired(mesh, ground, 0.1);
}

TEST_CASE("rewiring: a quad between corners that faces away is turned back where that is asked") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::grid(kWide - 1, kWide - 1));
  const WorkingMesh ground(surface);
  const MeshTree original(surface.mesh(), surface.positions());
  const QuadFacing facing(original.triangles());
  const auto countAway = [&](QuadMesh& mesh) {
    const MovingQuads moving(mesh, ground);
    std::size_t count = 0;
    for (Index q = 0; q < mesh.quads.size(); ++q) count += facing.isAway(moving.corners(q));
    return count;
  };
  QuadMesh mesh = quadsOn(ground);
  const auto [a, b, c, d] = mesh.quads[14];
  mesh.vertices[b].position += Vec3(0, 0.6, 0);
  mesh.vertices[c].position -= Vec3(0, 0.6, 0);
  mesh.vertices[d].position += Vec3(0.6, -0.8, 0);
  for (const Index v : {a, b, c, d}) mesh.vertices[v].kind = VertexKind::Corner;
  REQUIRE(countAway(mesh) == 1);
  const SurfaceKind kind = kindOf(mesh);
  QuadMesh unasked = mesh;  // a quad between corners has no normals to be compared with
  WorkBudget work;
  rewire(unasked, ground, work);
  CHECK(countAway(unasked) == 1);
  rewire(mesh, ground, work, &facing);
  CHECK(countAway(mesh) == 0);
  CHECK(check(mesh) == "");
  CHECK(kindOf(mesh) == kind);
}

TEST_CASE("rewiring: a vertex between two quads gets a third") {
  const OriginalSurface surface = shapes::surfaceOf(shapes::grid(kWide - 1, kWide - 1));
  const WorkingMesh ground(surface);
  QuadMesh mesh = quadsOn(ground);
  const SurfaceKind kind = kindOf(mesh);
  const auto [a, b, c, d] = mesh.quads[14];
  const auto middle = Index(mesh.vertices.size());
  mesh.vertices.push_back(mesh.vertices[a]);
  mesh.vertices.back().position = (mesh.position(a) + mesh.position(c)) / 2;
  mesh.quads[14] = {a, b, c, middle};
  mesh.quads.push_back({a, middle, c, d});
  mesh.curves.push_back({kNone, kNone, kNone, kNone});
  REQUIRE(check(mesh) != "");
  fillDoublets(mesh, ground);
  CHECK(check(mesh) == "");
  CHECK(kindOf(mesh) == kind);
}
