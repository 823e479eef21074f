// SPDX-License-Identifier: MIT
#include "mesh/euler_operators.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "geometry/triangle.h"
#include "mesh/mesh_builder.h"
#include "mesh/topology.h"
#include "support/mesh_check.h"
#include "support/shapes.h"
#include "support/soups.h"

using namespace remesher;

namespace {

struct Counts {
  long vertices, edges, faces;
  bool operator==(const Counts&) const = default;
};

Counts counts(const HalfedgeMesh& mesh) {
  return {long(mesh.vertexCount()), long(edgeCount(mesh)), long(mesh.faceCount())};
}

// The triangles as a set, each begun at its smallest vertex: equal for equal surfaces.
std::set<std::array<Vertex, 3>> surface(const HalfedgeMesh& mesh) {
  std::set<std::array<Vertex, 3>> result;
  for (Index f = 0; f < mesh.faceCapacity(); ++f) {
    if (!mesh.isAlive(Face(f))) continue;
    auto corners = mesh.vertices(Face(f));
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    result.insert(corners);
  }
  return result;
}

// Twice the area seen from above, turned-over triangles negative.
double signedArea(const HalfedgeMesh& mesh, const VertexData<Vec3>& positions) {
  double sum = 0;
  for (Index f = 0; f < mesh.faceCapacity(); ++f) {
    if (!mesh.isAlive(Face(f))) continue;
    const auto [a, b, c] = mesh.vertices(Face(f));
    sum += areaVector(positions[a], positions[b], positions[c]).z();
  }
  return sum;
}

// Calls body(mesh, h) with a fresh copy of every shape for every halfedge h.
template <class Body>
void onEveryHalfedge(Body body) {
  for (const shapes::Shape& shape : shapes::all()) {
    CAPTURE(shape.name);
    const HalfedgeMesh original = buildMesh(shape.mesh).mesh;
    const Index stride = original.faceCount() > 80 ? 5 : 1;
    for (Index h = 0; h < original.halfedgeCapacity(); h += stride) {
      CAPTURE(h);
      HalfedgeMesh mesh = original;
      body(mesh, Halfedge(h));
    }
  }
}

Halfedge find(const HalfedgeMesh& mesh, int from, int to) {
  return mesh.find(Vertex(Index(from)), Vertex(Index(to)));
}

}  // namespace

TEST_CASE("euler_operators: flip joins the vertices opposite the edge and changes no count") {
  onEveryHalfedge([](HalfedgeMesh& mesh, Halfedge h) {
    if (!EulerOperators::canFlip(mesh, h)) return;
    const Counts before = counts(mesh);
    const Vertex a = mesh.origin(h), b = mesh.tip(h), c = mesh.opposite(h),
                 d = mesh.opposite(mesh.twin(h));
    const int valences[] = {mesh.valence(a), mesh.valence(b), mesh.valence(c), mesh.valence(d)};
    const Halfedge flipped = EulerOperators(mesh).flip(h);
    CHECK(check(mesh) == "");
    CHECK(counts(mesh) == before);
    CHECK(mesh.origin(flipped) == c);
    CHECK(mesh.tip(flipped) == d);
    CHECK(flipped == mesh.prev(h));
    CHECK(mesh.origin(h) == d);
    CHECK(mesh.tip(h) == b);
    CHECK_FALSE(mesh.adjacent(a, b));
    CHECK(mesh.valence(a) == valences[0] - 1);
    CHECK(mesh.valence(b) == valences[1] - 1);
    CHECK(mesh.valence(c) == valences[2] + 1);
    CHECK(mesh.valence(d) == valences[3] + 1);
  });
}

TEST_CASE("euler_operators: flipping twice gives the same surface") {
  onEveryHalfedge([](HalfedgeMesh& mesh, Halfedge h) {
    if (!EulerOperators::canFlip(mesh, h)) return;
    const auto before = surface(mesh);
    const Halfedge flipped = EulerOperators(mesh).flip(h);
    CHECK(surface(mesh) != before);
    REQUIRE(EulerOperators::canFlip(mesh, flipped));
    EulerOperators(mesh).flip(flipped);
    CHECK(surface(mesh) == before);
  });
}

TEST_CASE("euler_operators: flip is refused on boundaries and where the new edge exists") {
  const HalfedgeMesh tetrahedron = buildMesh(shapes::tetrahedron()).mesh;
  for (Index h = 0; h < 12; ++h) CHECK_FALSE(EulerOperators::canFlip(tetrahedron, Halfedge(h)));
  const HalfedgeMesh grid = buildMesh(shapes::grid(3, 3)).mesh;
  for (Index h = 0; h < grid.halfedgeCapacity(); ++h)
    CHECK_FALSE((grid.isBoundary(Halfedge(h)) && EulerOperators::canFlip(grid, Halfedge(h))));
  // Two triangles back to back share all three edges: any flip would be a loop.
  const HalfedgeMesh pillow(3, std::vector<Index>{0, 1, 2, 0, 2, 1});
  CHECK_FALSE(EulerOperators::canFlip(pillow, Halfedge(0)));
}

TEST_CASE("euler_operators: both directions of an edge agree whether it may be flipped") {
  onEveryHalfedge([](HalfedgeMesh& mesh, Halfedge h) {
    if (!mesh.isBoundary(h))
      CHECK(EulerOperators::canFlip(mesh, h) == EulerOperators::canFlip(mesh, mesh.twin(h)));
  });
}

TEST_CASE("euler_operators: split puts a vertex on the edge and adds the exact counts") {
  onEveryHalfedge([](HalfedgeMesh& mesh, Halfedge h) {
    const bool boundary = mesh.isBoundary(h);
    const Counts before = counts(mesh);
    const Vertex a = mesh.origin(h), b = mesh.tip(h), c = mesh.opposite(h);
    const auto [m, beyond] = EulerOperators(mesh).split(h);
    CHECK(check(mesh) == "");
    CHECK(counts(mesh) ==
          Counts{before.vertices + 1, before.edges + 3 - boundary, before.faces + 2 - boundary});
    CHECK(mesh.origin(h) == a);
    CHECK(mesh.tip(h) == m);
    CHECK(mesh.origin(beyond) == m);
    CHECK(mesh.tip(beyond) == b);
    CHECK(mesh.opposite(h) == c);
    CHECK(mesh.opposite(beyond) == c);
    CHECK(mesh.valence(m) == 4 - boundary);
    CHECK(mesh.isBoundary(m) == boundary);
    CHECK_FALSE(mesh.adjacent(a, b));
  });
}

TEST_CASE("euler_operators: collapsing the new vertex undoes a split") {
  onEveryHalfedge([](HalfedgeMesh& mesh, Halfedge h) {
    const auto before = surface(mesh);
    const Halfedge beyond = EulerOperators(mesh).split(h).beyond;
    // A third vertex of valence 3 (2 on a boundary) before the split has one more now.
    REQUIRE(EulerOperators::canCollapse(mesh, beyond));
    EulerOperators(mesh).collapse(beyond);
    CHECK(check(mesh) == "");
    CHECK(surface(mesh) == before);
  });
}

TEST_CASE("euler_operators: collapse removes the exact counts and keeps the topology") {
  onEveryHalfedge([](HalfedgeMesh& mesh, Halfedge h) {
    if (!EulerOperators::canCollapse(mesh, h)) return;
    const bool boundary = mesh.isBoundary(h);
    const Counts before = counts(mesh);
    const std::size_t components = componentCount(mesh), loops = boundaryLoopCount(mesh);
    const Vertex a = mesh.origin(h), b = mesh.tip(h);
    const bool onBoundary = mesh.isBoundary(a) || mesh.isBoundary(b);
    const int valence = mesh.valence(a) + mesh.valence(b) - 4 + boundary;
    CHECK(EulerOperators(mesh).collapse(h) == b);
    CHECK(check(mesh) == "");
    CHECK(counts(mesh) ==
          Counts{before.vertices - 1, before.edges - 3 + boundary, before.faces - 2 + boundary});
    CHECK(componentCount(mesh) == components);
    CHECK(boundaryLoopCount(mesh) == loops);
    CHECK_FALSE(mesh.isAlive(a));
    CHECK(mesh.isBoundary(b) == onBoundary);
    CHECK(mesh.valence(b) == valence);
  });
}

TEST_CASE("euler_operators: collapse refuses to close a tunnel") {
  // Three edges go around the tube of a thin torus without a face between them.
  const BuiltMesh built = buildMesh(shapes::torus(8, 3));
  const HalfedgeMesh& mesh = built.mesh;
  int around = 0;
  for (Index i = 0; i < mesh.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    const Vec3 a = built.positions[mesh.origin(h)], b = built.positions[mesh.tip(h)];
    if (std::abs(a.x() * b.y() - a.y() * b.x()) > 1e-9 || a.dot(b) < 0) continue;
    CHECK_FALSE(EulerOperators::canCollapse(mesh, h));
    ++around;
  }
  CHECK(around == 8 * 3 * 2);
}

TEST_CASE("euler_operators: collapse refuses to join two boundary vertices through the inside") {
  const HalfedgeMesh strip = buildMesh(shapes::grid(4, 1)).mesh;
  for (Index h = 0; h < strip.halfedgeCapacity(); ++h)
    if (!strip.isBoundary(Halfedge(h)))
      CHECK_FALSE(EulerOperators::canCollapse(strip, Halfedge(h)));
}

TEST_CASE("euler_operators: collapse leaves the smallest surfaces alone") {
  const HalfedgeMesh tetrahedron = buildMesh(shapes::tetrahedron()).mesh;
  for (Index h = 0; h < 12; ++h) CHECK_FALSE(EulerOperators::canCollapse(tetrahedron, Halfedge(h)));
  const HalfedgeMesh triangle(3, std::vector<Index>{0, 1, 2});
  for (Index h = 0; h < 3; ++h) CHECK_FALSE(EulerOperators::canCollapse(triangle, Halfedge(h)));
  const HalfedgeMesh pillow(3, std::vector<Index>{0, 1, 2, 0, 2, 1});
  for (Index h = 0; h < 6; ++h) CHECK_FALSE(EulerOperators::canCollapse(pillow, Halfedge(h)));
}

TEST_CASE(
    "euler_operators: an inner vertex may be pulled onto the boundary, not the reverse kept") {
  //  3 - 2      4 is inside; collapsed into 0 it leaves 0 on the boundary.
  //  | 4 |
  //  0 - 1
  const std::vector<Index> fan = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4};
  HalfedgeMesh mesh(5, fan);
  const Halfedge inward = find(mesh, 4, 0);
  REQUIRE(EulerOperators::canCollapse(mesh, inward));
  EulerOperators(mesh).collapse(inward);
  CHECK(check(mesh) == "");
  CHECK(mesh.faceCount() == 2);
  CHECK(mesh.isBoundary(Vertex(0)));
  CHECK(boundaryLoopCount(mesh) == 1);
}

TEST_CASE("euler_operators: a planar surface keeps its area and its orientation") {
  // The signed area of a disk depends on its boundary alone, so any change inside keeps it.
  const BuiltMesh built = buildMesh(shapes::grid(5, 4));
  for (Index i = 0; i < built.mesh.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    CAPTURE(i);
    HalfedgeMesh mesh = built.mesh;
    VertexData<Vec3> positions = built.positions;
    const Vec3 middle = 0.5 * (positions[mesh.origin(h)] + positions[mesh.tip(h)]);
    const Vertex m = EulerOperators(mesh).split(h).vertex;
    positions.resize(mesh.vertexCapacity(), Vec3::Zero());
    positions[m] = middle;
    CHECK(signedArea(mesh, positions) == doctest::Approx(2 * 5 * 4));

    mesh = built.mesh;
    if (EulerOperators::canFlip(mesh, h)) EulerOperators(mesh).flip(h);
    CHECK(signedArea(mesh, positions) == doctest::Approx(2 * 5 * 4));

    mesh = built.mesh;
    if (mesh.isBoundary(mesh.origin(h)) || !EulerOperators::canCollapse(mesh, h)) continue;
    EulerOperators(mesh).collapse(h);
    CHECK(signedArea(mesh, positions) == doctest::Approx(2 * 5 * 4));
  }
}

TEST_CASE("euler_operators: any sequence of operators keeps every law") {
  soups::Random random(11);
  for (const shapes::Shape& shape : shapes::all()) {
    CAPTURE(shape.name);
    HalfedgeMesh mesh = buildMesh(shape.mesh).mesh;
    for (int step = 0; step < 300; ++step) {
      CAPTURE(step);
      const Halfedge h(Index(double(mesh.halfedgeCapacity()) * random.number()));
      if (!mesh.isAlive(h)) continue;
      const double choice = random.number();
      if (choice < 0.3)
        EulerOperators(mesh).split(h);
      else if (choice < 0.6 && EulerOperators::canFlip(mesh, h))
        EulerOperators(mesh).flip(h);
      else if (EulerOperators::canCollapse(mesh, h))
        EulerOperators(mesh).collapse(h);
      if (step % 10 == 0) REQUIRE(check(mesh) == "");
    }
    CHECK(check(mesh) == "");
    CHECK(eulerCharacteristic(mesh) == shape.chi);
    CHECK(componentCount(mesh) == shape.components);
    CHECK(boundaryLoopCount(mesh) == shape.loops);
  }
}

TEST_CASE("euler_operators: the places of what went are filled before the arrays grow") {
  HalfedgeMesh mesh = buildMesh(shapes::icosphere(3)).mesh;
  const std::size_t vertices = mesh.vertexCapacity(), faces = mesh.faceCapacity();
  const Halfedge h(0);
  REQUIRE(EulerOperators::canCollapse(mesh, h));
  EulerOperators(mesh).collapse(h);
  Index alive = 0;
  while (!mesh.isAlive(Halfedge(alive))) ++alive;
  EulerOperators(mesh).split(Halfedge(alive));
  CHECK(mesh.vertexCapacity() == vertices);
  CHECK(mesh.faceCapacity() == faces);
  CHECK(check(mesh) == "");
}
