// SPDX-License-Identifier: MIT
#include "remesh/steps/local_search.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <optional>

#include "support/runs.h"

using namespace remesher;

namespace {

// The length of the edge at which a change is proposed.
double lengthAt(const Run& run) { return run.mesh.edgeLength(run.scratch.change.halfedge); }

}  // namespace

TEST_CASE("local search: the change that gains most is carried out, and is at hand afterwards") {
  shapes::TestRun test(shapes::icosphere(3));
  const HalfedgeMesh& mesh = test.mesh.mesh();
  const Face f(7);
  double longest = 0;
  for (int i = 0; i < 3; ++i)
    longest = std::max(longest, test.mesh.edgeLength(HalfedgeMesh::halfedge(f, i)));
  LocalSearch search(test.run, [&](double) {
    return test.run.scratch.change.operation == Operation::Split ? lengthAt(test.run) : 0;
  });
  const std::size_t before = mesh.vertexCount();
  search.offerAtEdges(f, {EdgeMove::Flip, EdgeMove::Split, EdgeMove::Collapse});
  CHECK(search.best().gain == longest);
  CHECK(search.carryOut());
  CHECK(mesh.vertexCount() == before + 1);
  CHECK(test.run.scratch.change.operation == Operation::Split);
  CHECK(mesh.isAlive(test.run.scratch.result));
}

TEST_CASE("local search: a change that gains nothing is not carried out") {
  shapes::TestRun test(shapes::icosphere(2));
  const std::size_t vertices = test.mesh.mesh().vertexCount();
  const VertexData<Vec3> before = test.mesh.positions();
  std::size_t asked = 0;
  LocalSearch search(test.run, [&](double least) { return double(0 * ++asked) + least; });
  search.offerAtEdges(Face(0), {EdgeMove::Flip, EdgeMove::Split, EdgeMove::Collapse,
                                EdgeMove::CollapseInto, EdgeMove::Unite});
  search.offerSteps(Vertex(0), 0.25);
  CHECK(asked >= 3 * 8);
  CHECK_FALSE(search.carryOut());
  CHECK(test.mesh.mesh().vertexCount() == vertices);
  CHECK(test.mesh.positions().values() == before.values());
}

TEST_CASE("local search: collapses at hubs are not tried, other changes are") {
  constexpr std::size_t kFewSpokes = 6;
  shapes::TestRun test(shapes::icosphere(4));
  const HalfedgeMesh& mesh = test.mesh.mesh();
  const Hubs hubs(mesh, kFewSpokes);
  const Face f = HalfedgeMesh::face(mesh.outgoing(Vertex(Index(mesh.vertexCapacity() - 1))));
  const auto corners = mesh.vertices(f);
  REQUIRE(std::all_of(corners.begin(), corners.end(), [&](Vertex v) { return hubs.contains(v); }));
  bool isAny = false, isCollapse = false;
  LocalSearch search(
      test.run,
      [&](double) {
        isAny = true;
        isCollapse = isCollapse || test.run.scratch.change.operation == Operation::Collapse;
        return 0;
      },
      &hubs);
  search.offerAtEdges(f, {EdgeMove::Collapse, EdgeMove::CollapseInto, EdgeMove::Unite});
  CHECK_FALSE(isAny);
  search.offerAtEdges(f, {EdgeMove::Flip, EdgeMove::Split});
  CHECK(isAny);
  CHECK_FALSE(isCollapse);
}

TEST_CASE("local search: the worst triangles come first, and are mended while bad, a few times") {
  constexpr int kInARow = 3;
  shapes::TestRun test(shapes::icosphere(2));
  const HalfedgeMesh& mesh = test.mesh.mesh();
  FaceData<int> faults(mesh.faceCapacity(), 0);
  for (Index i = 0; i < faults.size(); ++i) faults[Face(i)] = int(i % 6);
  const auto isBad = [&](Face f) { return faults[f] > 0; };
  const std::vector<Face> faces = worstFirst(
      mesh, [&](Face f) { return isBad(f) ? std::optional(double(faults[f])) : std::nullopt; });
  CHECK(faces.size() == mesh.faceCount() - (mesh.faceCount() + 5) / 6);
  CHECK(std::is_sorted(faces.begin(), faces.end(), [&](Face a, Face b) {
    return faults[a] != faults[b] ? faults[a] > faults[b] : a < b;
  }));
  const auto isHelpless = [](Face f) { return f.index % 12 == 5; };
  CHECK(mendEach(faces, kInARow, isBad, [&](Face f) {
    if (!isHelpless(f)) --faults[f];
    return !isHelpless(f);
  }));
  for (const Face f : faces) {
    const int before = int(f.index % 6);
    CHECK(faults[f] == (isHelpless(f) ? before : std::max(0, before - kInARow)));
  }
  CHECK_FALSE(mendEach(faces, kInARow, isBad, [](Face) { return false; }));
}
