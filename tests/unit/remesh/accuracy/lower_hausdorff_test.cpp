// SPDX-License-Identifier: MIT
#include "remesh/accuracy/lower_hausdorff.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "geometry/triangle_tree.h"
#include "remesh/accuracy/star_search.h"
#include "remesh/steps/relax.h"
#include "support/runs.h"

using namespace remesher;

namespace {

// A sphere with bumps, from whose tops vertices slide down when they are smoothed.
TriangleMesh bumpySphere() {
  TriangleMesh mesh = shapes::icosphere(6);
  for (std::size_t i = 0; i < mesh.positions.size(); i += 29) mesh.positions[i] *= 1.12;
  return mesh;
}

// Two spheres one in the other, nearer to each other than an edge is long, with bumps of the inner
// one that reach into what those of the outer one leave.
TriangleMesh dentedSkins() {
  TriangleMesh mesh = shapes::icosphere(5);
  const auto count = Index(mesh.positions.size());
  for (const Index v : std::vector(mesh.indices)) mesh.indices.push_back(count + v);
  for (Index i = 0; i < count; ++i) {
    const Vec3 p = mesh.positions[i];
    mesh.positions.push_back((i % 29 == 0 ? 1.08 : 0.97) * p);
    if (i % 29 == 0) mesh.positions[i] = 1.12 * p;
  }
  return mesh;
}

// Flips keep the smoothing from finding everything even already.
void wearDown(shapes::TestRun& test) {
  for (Index i = 0; i < test.mesh.mesh().halfedgeCapacity(); i += 7)
    if (proposeFlip(test.mesh, Halfedge(i), test.run.scratch.change)) commit(test.run);
  relax(test.run, 8);
}

double largest(const TwoSidedDistance& distances, const HalfedgeMesh& mesh) {
  double result = 0;
  for (Index i = 0; i < mesh.faceCapacity(); ++i)
    if (mesh.isAlive(Face(i))) result = std::max(result, distances.of(Face(i)));
  return result;
}

}  // namespace

TEST_CASE("places: no distance is smaller than the true one, and few are larger") {
  for (const TriangleMesh& shape : {bumpySphere(), shapes::torus(16, 8), shapes::cube(4)}) {
    shapes::TestRun test(shape);
    wearDown(test);
    const std::vector<Index> triangles = test.mesh.mesh().triangles();
    const TriangleTree tree(test.mesh.positions().values(), triangles);
    const std::vector<Place> places = measurePlaces(test.run, 0, 0);
    CHECK(places.size() >= shape.positions.size());
    std::size_t larger = 0;
    for (const Place& place : places) {
      const double exact = std::sqrt(tree.nearest(place.position).squaredDistance);
      CHECK(place.distance >= exact - 1e-12);
      larger += place.distance > exact + 1e-12;
    }
    CHECK(larger * 20 <= places.size());
  }
}

TEST_CASE("two-sided distance: what a move is said to bring is what it brings") {
  shapes::TestRun test(bumpySphere());
  wearDown(test);
  TwoSidedDistance distances(test.run);
  const Vertex v(17);
  const Placement to = test.mesh.onSurface(test.surface.at(v));
  const double expected = std::max(distances.around(v, to), distances.onRim(v));
  test.mesh.move(v, to);
  distances.update(v);
  double found = 0;
  test.mesh.mesh().forEachOutgoing(
      v, [&](Halfedge h) { found = std::max(found, distances.of(HalfedgeMesh::face(h))); });
  CHECK(found == doctest::Approx(expected));
}

TEST_CASE("two-sided distance: what a flip is said to bring is what it brings") {
  shapes::TestRun test(bumpySphere());
  wearDown(test);
  const HalfedgeMesh& mesh = test.mesh.mesh();
  TwoSidedDistance distances(test.run);
  std::size_t flips = 0;
  for (Index i = 0; i < mesh.halfedgeCapacity(); i += 5) {
    const Halfedge h(i);
    if (!proposeFlip(test.mesh, h, test.run.scratch.change)) continue;
    const Face left = mesh.face(h), right = mesh.face(mesh.twin(h));
    const double expected = distances.ifFlipped(h);
    distances.update(test.mesh.flip(h));
    // Walks to the original begin at other corners afterwards.
    const double found = std::max(distances.of(left), distances.of(right));
    CHECK(found == doctest::Approx(expected).epsilon(0.02));
    ++flips;
  }
  CHECK(flips > 100);
}

TEST_CASE("star search: the best place is nowhere farther than the first, and pierces nothing") {
  for (const TriangleMesh& shape : {bumpySphere(), dentedSkins()}) {
    shapes::TestRun test(shape);
    wearDown(test);
    TwoSidedDistance distances(test.run);
    const Crossings crossings(test.mesh);
    int improved = 0;
    for (Index i = 0; i < test.mesh.mesh().vertexCapacity(); ++i) {
      const double before = distances.around(Vertex(i), test.mesh.placement(Vertex(i)));
      StarSearch search(test.run, crossings, distances, {Vertex(i), radians(20)});
      search.descend();
      CHECK(search.distance() <= before);
      CHECK(distances.around(Vertex(i), search.best()) == search.distance());
      if (search.distance() == before) continue;
      LocalChange change;
      proposePlacement(test.mesh, Vertex(i), search.best(), change);
      CHECK_FALSE(crossings.grow(change));
      ++improved;
    }
    CHECK(improved > 100);
  }
}

TEST_CASE("lower Hausdorff: the largest distance falls and no good triangle is lost") {
  for (const TriangleMesh& shape : {bumpySphere(), shapes::icosphere(5)}) {
    shapes::TestRun test(shape);
    wearDown(test);
    const double before = largest(TwoSidedDistance(test.run), test.mesh.mesh());
    const double angle = shapes::worstAngle(test.mesh);
    const std::size_t vertices = test.mesh.mesh().vertexCount();
    lowerHausdorff(test.run);
    CHECK(largest(TwoSidedDistance(test.run), test.mesh.mesh()) < before);
    CHECK(shapes::worstAngle(test.mesh) >= std::min(angle, radians(31)));
    CHECK(test.mesh.mesh().vertexCount() == vertices);
    CHECK(check(test.mesh.mesh()) == "");
  }
}
