// SPDX-License-Identifier: MIT
#include "mesh/mesh_builder.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.h"
#include "mesh/topology.h"
#include "support/mesh_check.h"
#include "support/shapes.h"
#include "support/soups.h"

using namespace remesher;

namespace {

std::size_t warned(const BuiltMesh& built, const std::string& code) {
  for (const Warning& warning : built.warnings)
    if (warning.code == code) return warning.count;
  return 0;
}

ErrorCode refusal(const TriangleMesh& input) {
  try {
    buildMesh(input);
  } catch (const Error& error) {
    CHECK(std::string(error.what()).ends_with("."));
    return error.code;
  }
  return ErrorCode::Internal;
}

// Each corner of the result is the corner of the input it says it is.
void checkSources(const TriangleMesh& input, const BuiltMesh& built) {
  const HalfedgeMesh& mesh = built.mesh;
  REQUIRE(built.positions.size() == mesh.vertexCapacity());
  REQUIRE(built.sources.size() == mesh.vertexCapacity());
  REQUIRE(built.wedges.size() == mesh.halfedgeCapacity());
  REQUIRE(built.triangles.size() == mesh.faceCapacity());
  for (Index i = 0; i < mesh.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    const Index wedge = built.wedges[h], triangle = built.triangles[HalfedgeMesh::face(h)];
    const auto corner = input.indices.begin() + 3 * triangle;
    CHECK(std::count(corner, corner + 3, wedge) == 1);
    CHECK(input.positions[wedge] == built.positions[mesh.origin(h)]);
  }
  for (Index i = 0; i < mesh.vertexCapacity(); ++i) {
    const Index source = built.sources[Vertex(i)];
    const auto first =
        std::find(input.positions.begin(), input.positions.end(), built.positions[Vertex(i)]);
    CHECK(source == Index(first - input.positions.begin()));
  }
}

TriangleMesh randomBag(soups::Random& random) {
  TriangleMesh bag;
  const auto upTo = [&](double n) { return Index(n * random.number()); };
  const Index vertices = 3 + upTo(8), triangles = 1 + upTo(14);
  for (Index v = 0; v < vertices; ++v) bag.positions.emplace_back(upTo(3), upTo(3), upTo(2));
  for (Index i = 0; i < 3 * triangles; ++i) bag.indices.push_back(upTo(vertices));
  return bag;
}

// The same surface, its vertices and triangles in no order.
TriangleMesh shuffled(const TriangleMesh& mesh) {
  soups::Random random(5);
  const auto anyOrder = [&](std::size_t size) {
    std::vector<Index> order(size);
    for (Index i = 0; i < size; ++i) {
      const auto k = std::size_t((i + 1) * random.number());
      order[i] = order[k];
      order[k] = i;
    }
    return order;
  };
  const std::vector<Index> vertices = anyOrder(mesh.positions.size());
  TriangleMesh result;
  result.positions.resize(vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v)
    result.positions[vertices[v]] = mesh.positions[v];
  for (const Index t : anyOrder(mesh.triangleCount()))
    for (std::size_t k = 0; k < 3; ++k)
      result.indices.push_back(vertices[mesh.indices[3 * std::size_t{t} + k]]);
  return result;
}

// A vertex with two neighbours inside the surface: all its faces are two, back to back.
bool hasPocket(const HalfedgeMesh& mesh) {
  for (Index v = 0; v < mesh.vertexCapacity(); ++v)
    if (!mesh.isBoundary(Vertex(v)) && mesh.valence(Vertex(v)) < 3) return true;
  return false;
}

}  // namespace

TEST_CASE("mesh_builder: a manifold comes through whole and without a warning") {
  for (const auto& shape : shapes::manifolds()) {
    CAPTURE(shape.name);
    const auto& [name, input, chi, components, loops] = shape;
    const BuiltMesh built = buildMesh(input);
    CHECK(check(built.mesh) == "");
    CHECK(built.warnings.empty());
    CHECK(built.mesh.faceCount() == input.triangleCount());
    CHECK(eulerCharacteristic(built.mesh) == chi);
    CHECK(componentCount(built.mesh) == components);
    CHECK(boundaryLoopCount(built.mesh) == loops);
    checkSources(input, built);
  }
}

TEST_CASE("mesh_builder: what is no manifold is cut into one") {
  for (const auto& shape : shapes::nonManifolds()) {
    CAPTURE(shape.name);
    const auto& [name, input, chi, components, loops] = shape;
    const BuiltMesh built = buildMesh(input);
    CHECK(check(built.mesh) == "");
    CHECK(built.mesh.faceCount() == input.triangleCount());
    CHECK(eulerCharacteristic(built.mesh) == chi);
    CHECK(componentCount(built.mesh) == components);
    CHECK(boundaryLoopCount(built.mesh) == loops);
    checkSources(input, built);
  }
}

TEST_CASE("mesh_builder: vertices at one place become one") {
  // Frequency n of an icosphere has 10 n² + 2 places, and three vertices per triangle are given.
  const BuiltMesh built = buildMesh(shapes::icosphere(4));
  CHECK(built.mesh.vertexCount() == 10 * 4 * 4 + 2);
}

TEST_CASE("mesh_builder: vertices keep the order of the input, unused ones are left out") {
  TriangleMesh input = shapes::grid(3, 2);
  input.positions.insert(input.positions.begin(), Vec3(9, 9, 9));
  for (Index& v : input.indices) ++v;
  const BuiltMesh built = buildMesh(input);
  CHECK(built.mesh.vertexCount() == 12);
  for (Index v = 0; v < 12; ++v) CHECK(built.sources[Vertex(v)] == v + 1);
  CHECK(built.mesh.triangles().size() == input.indices.size());
}

TEST_CASE("mesh_builder: of a large mesh neighbours come to lie side by side, in any order given") {
  const TriangleMesh input = shuffled(shapes::grid(350, 300));
  const BuiltMesh built = buildMesh(input);
  CHECK(check(built.mesh) == "");
  CHECK(built.warnings.empty());
  CHECK(built.mesh.vertexCount() == input.positions.size());
  CHECK(built.mesh.faceCount() == input.triangleCount());
  std::vector<double> gaps;
  std::size_t wrong = 0;
  for (Index i = 0; i < built.mesh.halfedgeCapacity(); ++i) {
    const Vertex from = built.mesh.origin(Halfedge(i)), to = built.mesh.tip(Halfedge(i));
    gaps.push_back(std::abs(double(from.index) - double(to.index)));
    const Index triangle = built.triangles[HalfedgeMesh::face(Halfedge(i))];
    const Index wedge = built.wedges[Halfedge(i)];
    const auto corner = input.indices.begin() + 3 * triangle;
    wrong += std::count(corner, corner + 3, wedge) != 1 || built.sources[from] != wedge ||
             input.positions[wedge] != built.positions[from];
  }
  CHECK(wrong == 0);
  std::nth_element(gaps.begin(), gaps.begin() + gaps.size() / 2, gaps.end());
  CHECK(gaps[gaps.size() / 2] < 16);
}

TEST_CASE("mesh_builder: triangles without three distinct corners are removed") {
  TriangleMesh input = shapes::grid(1, 1);
  const Index copy = shapes::addVertex(input, input.positions[0]);
  shapes::addTriangle(input, 0, 1, 1);
  shapes::addTriangle(input, 0, copy, 3);
  const BuiltMesh built = buildMesh(input);
  CHECK(warned(built, "DEGENERATE_TRIANGLES_REMOVED") == 2);
  CHECK(built.mesh.faceCount() == 2);
  checkSources(input, built);
}

TEST_CASE("mesh_builder: a triangle without area but with three corners stays") {
  TriangleMesh input;
  input.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}};
  input.indices = {0, 2, 1, 0, 1, 3, 1, 2, 3};
  const BuiltMesh built = buildMesh(input);
  CHECK(built.mesh.faceCount() == 3);
  CHECK(built.warnings.empty());
}

TEST_CASE("mesh_builder: a repeated triangle is removed, a sheet of one triangle refused") {
  TriangleMesh input = shapes::tetrahedron();
  shapes::addTriangle(input, 1, 2, 0);  // the first one, begun at another corner
  shapes::addTriangle(input, 0, 1, 2);
  const BuiltMesh built = buildMesh(input);
  CHECK(warned(built, "DUPLICATE_TRIANGLES_REMOVED") == 2);
  CHECK(built.mesh.faceCount() == 4);
  CHECK(eulerCharacteristic(built.mesh) == 2);

  TriangleMesh pillow;
  pillow.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  pillow.indices = {0, 1, 2, 0, 2, 1};
  CHECK_THROWS_AS(buildMesh(pillow), Error);
}

TEST_CASE("mesh_builder: the majority of a component keeps its orientation") {
  TriangleMesh input = shapes::twoComponents();
  std::swap(input.indices[0], input.indices[1]);
  for (const std::size_t f : {4, 5, 6}) std::swap(input.indices[3 * f], input.indices[3 * f + 1]);
  const BuiltMesh built = buildMesh(input);
  CHECK(warned(built, "INCONSISTENT_ORIENTATION_FIXED") == 2);
  CHECK(check(built.mesh) == "");
  CHECK(eulerCharacteristic(built.mesh) == 4);
  CHECK(built.mesh.vertices(Face(1)) == std::array{Vertex(0), Vertex(2), Vertex(3)});
  checkSources(input, built);
}

TEST_CASE("mesh_builder: every repair is counted in its warning") {
  CHECK(warned(buildMesh(shapes::moebiusStrip(7)), "NON_ORIENTABLE_CUT") > 0);
  CHECK(warned(buildMesh(shapes::threeAtAnEdge()), "NON_MANIFOLD_EDGES_SPLIT") == 1);
  CHECK(warned(buildMesh(shapes::threeAtAnEdge()), "NON_MANIFOLD_VERTICES_SPLIT") == 0);
  CHECK(warned(buildMesh(shapes::bowTie()), "NON_MANIFOLD_VERTICES_SPLIT") == 1);
}

TEST_CASE("mesh_builder: a surface with one side is cut where its file turns over") {
  TriangleMesh strip = shapes::moebiusStrip(40);
  std::rotate(strip.indices.begin(), strip.indices.begin() + 51, strip.indices.end());
  const BuiltMesh built = buildMesh(strip);
  CHECK(warned(built, "INCONSISTENT_ORIENTATION_FIXED") == 0);
  CHECK(warned(built, "NON_ORIENTABLE_CUT") == 1);
  // The middle of the edge from which the strip's triangles go on as they began, turned over.
  const std::optional<Vec3> at = built.warnings.back().at;
  REQUIRE(at);
  CHECK(*at == (strip.positions[0] + strip.positions[40]) / 2);
}

TEST_CASE("mesh_builder: any bag of triangles becomes a manifold") {
  soups::Random random(5);
  for (int round = 0; round < 5000; ++round) {
    CAPTURE(round);
    const TriangleMesh bag = randomBag(random);
    try {
      const BuiltMesh built = buildMesh(bag);
      REQUIRE(check(built.mesh) == "");
      REQUIRE(!hasPocket(built.mesh));
      REQUIRE(built.mesh.vertexCount() == built.mesh.vertexCapacity());
      REQUIRE(built.mesh.faceCount() + warned(built, "DEGENERATE_TRIANGLES_REMOVED") +
                  warned(built, "DUPLICATE_TRIANGLES_REMOVED") +
                  warned(built, "BACK_TO_BACK_TRIANGLES_REMOVED") ==
              bag.triangleCount());
    } catch (const Error& error) {
      REQUIRE(error.code == ErrorCode::NoTriangles);
    }
  }
}

TEST_CASE("mesh_builder: input that cannot be a mesh is refused with its reason") {
  TriangleMesh input;
  CHECK(refusal(input) == ErrorCode::NoTriangles);
  input.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}};
  input.indices = {0, 1, 2, 1, 0, 1};
  CHECK(refusal(input) == ErrorCode::NoTriangles);
  input.indices = {0, 1, 3};
  CHECK(refusal(input) == ErrorCode::IndexOutOfRange);
  input.indices = {0, 1};
  CHECK(refusal(input) == ErrorCode::IndexOutOfRange);
  input.indices = {0, 1, 2};
  for (const double bad : {std::nan(""), HUGE_VAL}) {
    input.positions[2] = {0, bad, 0};
    CHECK(refusal(input) == ErrorCode::NonFinite);
  }
}
