// SPDX-License-Identifier: MIT
#include "remesh/quads/map/cut.h"

#include <numbers>
#include <vector>

namespace remesher {

namespace {

int modulo4(int x) { return ((x % 4) + 4) % 4; }

// Quarter turns for each triangle such that crosses agree along a tree of neighbours, which grows
// breadth first. The edges of the tree are marked.
struct Combed {
  FaceData<int> turns;
  HalfedgeData<char> isTree;
};

Combed comb(const HalfedgeMesh& mesh, const CrossField& field) {
  Combed combed{FaceData<int>(mesh.faceCapacity(), 0),
                HalfedgeData<char>(mesh.halfedgeCapacity(), 0)};
  FaceData<char> seen(mesh.faceCapacity(), 0);
  std::vector<Face> queue;
  for (Index i = 0; i < mesh.faceCapacity(); ++i) {
    if (seen[Face(i)]) continue;
    seen[Face(i)] = 1;
    queue.assign(1, Face(i));
    for (std::size_t k = 0; k < queue.size(); ++k)
      for (int corner = 0; corner < 3; ++corner) {
        const Halfedge h = HalfedgeMesh::halfedge(queue[k], corner), twin = mesh.twin(h);
        if (!twin || seen[HalfedgeMesh::face(twin)]) continue;
        const Face next = HalfedgeMesh::face(twin);
        seen[next] = 1;
        combed.turns[next] = combed.turns[queue[k]] + field.turn[h];
        combed.isTree[h] = combed.isTree[twin] = 1;
        queue.push_back(next);
      }
  }
  return combed;
}

// Takes back ends of the cut that are at no singular vertex and no boundary.
void peel(const HalfedgeMesh& mesh, const VertexData<int>& singular, HalfedgeData<char>& isCut) {
  const auto onlyCut = [&](Vertex v) {
    Halfedge only;
    int count = 0;
    mesh.forEachOutgoing(v, [&](Halfedge h) {
      if (!isCut[h]) return;
      only = h;
      ++count;
    });
    return count == 1 ? only : Halfedge();
  };
  for (Index i = 0; i < mesh.vertexCapacity(); ++i)
    for (Vertex v(i); mesh.isAlive(v) && !mesh.isBoundary(v) && singular[v] == 0;) {
      const Halfedge h = onlyCut(v);
      if (!h) break;
      isCut[h] = isCut[mesh.twin(h)] = 0;
      v = mesh.tip(h);
    }
}

}  // namespace

CutField cutOpen(const WorkingMesh& mesh, const CrossField& field,
                 const VertexData<int>& singular) {
  const HalfedgeMesh& m = mesh.mesh();
  const Combed combed = comb(m, field);
  CutField cut{field.angle, HalfedgeData<int>(m.halfedgeCapacity(), 0),
               HalfedgeData<char>(m.halfedgeCapacity(), 0)};
  for (Index f = 0; f < m.faceCapacity(); ++f)
    cut.angle[Face(f)] += combed.turns[Face(f)] * (std::numbers::pi / 2);
  for (Index i = 0; i < m.halfedgeCapacity(); ++i) {
    const Halfedge h(i), twin = m.twin(h);
    if (!twin) continue;
    cut.isCut[h] = !combed.isTree[h];
    cut.turn[h] = modulo4(field.turn[h] + combed.turns[HalfedgeMesh::face(h)] -
                          combed.turns[HalfedgeMesh::face(twin)]);
  }
  peel(m, singular, cut.isCut);
  return cut;
}

}  // namespace remesher
