// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include "mesh/euler_operators.h"
#include "mesh/mesh_builder.h"
#include "support/mesh_check.h"
#include "support/shapes.h"

namespace remesher {

// Breaks what no operator would.
class MeshBreaker {
 public:
  explicit MeshBreaker(HalfedgeMesh mesh) : mesh_(std::move(mesh)) {}

  MeshBreaker& origin(Index h, Vertex v) {
    mesh_.origin_[h] = v;
    return *this;
  }
  MeshBreaker& twin(Index h, Halfedge t) {
    mesh_.twin_[h] = t;
    return *this;
  }
  MeshBreaker& outgoing(Index v, Halfedge h) {
    mesh_.outgoing_[v] = h;
    return *this;
  }
  MeshBreaker& freeVertex(Index v) {
    mesh_.freeVertices_.push_back(v);
    return *this;
  }
  MeshBreaker& freeFace(Index f) {
    mesh_.freeFaces_.push_back(f);
    return *this;
  }
  bool reports(const std::string& words) const {
    INFO(check(mesh_));
    return check(mesh_).find(words) != std::string::npos;
  }

 private:
  HalfedgeMesh mesh_;
};

}  // namespace remesher

using namespace remesher;

namespace {

MeshBreaker square() {                                                        // 3-2
  return MeshBreaker(HalfedgeMesh(4, std::vector<Index>{0, 1, 2, 0, 2, 3}));  // 0-1
}

}  // namespace

TEST_CASE("check: every shape is sound, and stays so with holes in its arrays") {
  CHECK(check(HalfedgeMesh()) == "");
  for (const shapes::Shape& shape : shapes::all()) {
    CAPTURE(shape.name);
    HalfedgeMesh mesh = buildMesh(shape.mesh).mesh;
    CHECK(check(mesh) == "");
    for (Index h = 0; h < mesh.halfedgeCapacity(); ++h)
      if (mesh.isAlive(Halfedge(h)) && EulerOperators::canCollapse(mesh, Halfedge(h)))
        EulerOperators(mesh).collapse(Halfedge(h));
    CHECK(check(mesh) == "");
  }
}

TEST_CASE("check: a broken face is found") {
  CHECK(square().origin(1, Vertex()).reports("half dead"));
  CHECK(square().origin(1, Vertex(9)).reports("out of range"));
  CHECK(square().origin(1, Vertex(2)).reports("a vertex twice"));
  CHECK(square().outgoing(1, Halfedge()).reports("has a dead vertex"));
  CHECK(square().freeFace(0).reports("faceCount()"));
}

TEST_CASE("check: a broken twin is found") {
  CHECK(square().twin(0, Halfedge(77)).reports("dead twin"));
  CHECK(square().twin(2, Halfedge(4)).reports("not its twin's twin"));
  CHECK(square().twin(0, Halfedge(4)).twin(4, Halfedge(0)).reports("opposite to its twin"));
}

TEST_CASE("check: an edge that is there twice is found") {
  // The two triangles are unlinked at their common edge 0-2.
  CHECK(square().twin(2, Halfedge()).twin(3, Halfedge()).reports("two edges join"));
}

TEST_CASE("check: a broken vertex is found") {
  CHECK(square().outgoing(1, Halfedge(0)).reports("leaves another"));
  CHECK(square().outgoing(0, Halfedge(3)).reports("does not follow"));
  CHECK(square().freeVertex(0).reports("vertexCount()"));
  // Two triangles that touch in vertex 0: one fan is reached from its outgoing halfedge.
  CHECK(MeshBreaker(HalfedgeMesh(5, std::vector<Index>{0, 1, 2, 0, 3, 4})).reports("misses"));
}
