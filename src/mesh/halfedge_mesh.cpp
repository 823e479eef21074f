// SPDX-License-Identifier: MIT
#include "mesh/halfedge_mesh.h"

#include "mesh/edge_groups.h"

namespace remesher {

HalfedgeMesh::HalfedgeMesh(std::size_t vertexCount, std::span<const Index> triangles)
    : origin_(triangles.size()), twin_(triangles.size()), outgoing_(vertexCount) {
  for (Index h = 0; h < triangles.size(); ++h) origin_[h] = Vertex(triangles[h]);
  const EdgeGroups edges(vertexCount, triangles);
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (edges[e].size() == 2) link(Halfedge(edges[e][0]), Halfedge(edges[e][1]));
  findOutgoing();
}

HalfedgeMesh::HalfedgeMesh(std::size_t vertexCount, std::span<const Index> triangles,
                           std::span<const Index> twins)
    : origin_(triangles.size()), twin_(triangles.size()), outgoing_(vertexCount) {
  for (Index h = 0; h < triangles.size(); ++h) {
    origin_[h] = Vertex(triangles[h]);
    twin_[h] = Halfedge(twins[h]);
  }
  findOutgoing();
}

void HalfedgeMesh::findOutgoing() {
  for (Index h = 0; h < origin_.size(); ++h) outgoing_[origin_[h].index] = Halfedge(h);
  for (Index v = 0; v < outgoing_.size(); ++v) {
    if (isAlive(Vertex(v))) {
      setOutgoingToBoundary(Vertex(v));
    } else {
      freeVertices_.push_back(v);
    }
  }
}

void HalfedgeMesh::setOutgoingToBoundary(Vertex v) {
  const Halfedge first = outgoing(v);
  Halfedge h = first;
  while (!isBoundary(h)) {
    h = next(twin(h));
    if (h == first) return;
  }
  outgoing_[v.index] = h;
}

void HalfedgeMesh::link(Halfedge h, Halfedge t) {
  twin_[h.index] = t;
  if (t) twin_[t.index] = h;
}

int HalfedgeMesh::valence(Vertex v) const {
  int n = 0;
  forEachNeighbor(v, [&](Vertex) { ++n; });
  return n;
}

bool HalfedgeMesh::hasMoreNeighbors(Vertex v, int than) const {
  const Halfedge first = outgoing(v);
  Halfedge h = first;
  for (int seen = isBoundary(v) ? 2 : 1; seen <= than; ++seen) {
    h = twin(prev(h));
    if (!h || h == first) return false;
  }
  return true;
}

Halfedge HalfedgeMesh::find(Vertex from, Vertex to) const {
  const Halfedge first = outgoing(from);
  if (tip(first) == to) return first;
  Halfedge h = first;
  do {
    const Halfedge back = prev(h);
    h = twin(back);
    if (origin(back) == to) return h;
  } while (h && h != first);
  return {};
}

HalfedgeMesh::Renumbering HalfedgeMesh::compact() {
  Renumbering map{std::vector<Index>(vertexCapacity(), kNone),
                  std::vector<Index>(faceCapacity(), kNone)};
  Index vertices = 0, faces = 0;
  for (Index v = 0; v < vertexCapacity(); ++v)
    if (isAlive(Vertex(v))) map.vertex[v] = vertices++;
  for (Index f = 0; f < faceCapacity(); ++f)
    if (isAlive(Face(f))) map.face[f] = faces++;
  const auto moved = [&](Halfedge h) {
    return h ? Halfedge(3 * map.face[h.index / 3] + h.index % 3) : Halfedge();
  };
  for (Index h = 0; h < halfedgeCapacity(); ++h) {
    if (!isAlive(Halfedge(h))) continue;
    const Index to = moved(Halfedge(h)).index;  // never behind h: the order is kept
    origin_[to] = Vertex(map.vertex[origin_[h].index]);
    twin_[to] = moved(twin_[h]);
  }
  for (Index v = 0; v < vertexCapacity(); ++v)
    if (map.vertex[v] != kNone) outgoing_[map.vertex[v]] = moved(outgoing_[v]);
  origin_.resize(3 * std::size_t{faces});
  twin_.resize(3 * std::size_t{faces});
  outgoing_.resize(vertices);
  freeVertices_.clear();
  freeFaces_.clear();
  return map;
}

std::vector<Index> HalfedgeMesh::triangles() const {
  std::vector<Index> result;
  result.reserve(3 * faceCount());
  for (const Vertex v : origin_)
    if (v) result.push_back(v.index);
  return result;
}

}  // namespace remesher
