// SPDX-License-Identifier: MIT
#include "original/surface/original_surface.h"

#include "geometry/box.h"
#include "geometry/triangle.h"

namespace remesher {

OriginalSurface::OriginalSurface(BuiltMesh built, FeatureCurves curves, FlatRegions flats)
    : built_(std::move(built)), curves_(std::move(curves)), flats_(std::move(flats)) {
  Box box;
  for (const Vec3& p : positions().values()) box.extend(p);
  diagonal_ = (box.high - box.low).norm();
  barriers_.assign(mesh().halfedgeCapacity(), 0);
  for (Index h = 0; h < mesh().halfedgeCapacity(); ++h)
    barriers_[Halfedge(h)] = curves_.isCurve(Halfedge(h));
  computeNormals();
}

// Around each vertex the corners between two curve edges share one normal.
void OriginalSurface::computeNormals() {
  const HalfedgeMesh& m = mesh();
  FaceData<Vec3> faceNormals(m.faceCapacity(), Vec3::Zero());
  for (Index i = 0; i < m.faceCapacity(); ++i) {
    const auto [a, b, c] = m.vertices(Face(i));
    faceNormals[Face(i)] = areaVector(positions()[a], positions()[b], positions()[c]);
    area_ += 0.5 * faceNormals[Face(i)].norm();
  }
  VertexData<char> isOnCurve(m.vertexCapacity(), 0);
  for (Index i = 0; i < m.halfedgeCapacity(); ++i)
    if (barriers_[Halfedge(i)]) isOnCurve[m.origin(Halfedge(i))] = 1;
  normalOf_.assign(m.halfedgeCapacity(), kNone);
  normals_.reserve(m.vertexCapacity());
  for (Index i = 0; i < m.halfedgeCapacity(); ++i) {
    if (normalOf_[Halfedge(i)] != kNone) continue;
    // At a curve a side begins at its clockwise end; without a curve the whole star is one side.
    Halfedge first(i);
    if (isOnCurve[m.origin(first)])
      while (!barriers_[first]) first = m.next(m.twin(first));
    else
      first = m.twin(m.prev(first));
    Vec3 sum = Vec3::Zero();
    Halfedge h = first;
    do {
      normalOf_[h] = Index(normals_.size());
      sum += faceNormals[m.face(h)];
      h = m.prev(h);
      h = barriers_[h] ? Halfedge() : m.twin(h);
    } while (h && h != first);
    normals_.push_back(sum.normalized());
  }
}

Vec3 OriginalSurface::position(const SurfacePoint& p) const {
  const auto [a, b, c] = mesh().vertices(p.face);
  // Weights may sum to slightly more or less than one; a coordinate shared by all corners must not
  // change.
  if (isFlat(p.face))
    return positions()[a] + p.barycentric[1] * (positions()[b] - positions()[a]) +
           p.barycentric[2] * (positions()[c] - positions()[a]);
  return p.barycentric[0] * positions()[a] + p.barycentric[1] * positions()[b] +
         p.barycentric[2] * positions()[c];
}

Vec3 OriginalSurface::normal(const SurfacePoint& p) const {
  const Halfedge h = HalfedgeMesh::halfedge(p.face);
  return p.barycentric[0] * cornerNormal(h) + p.barycentric[1] * cornerNormal(mesh().next(h)) +
         p.barycentric[2] * cornerNormal(mesh().prev(h));
}

SurfacePoint OriginalSurface::at(Vertex v) const {
  const Halfedge h = mesh().outgoing(v);
  Vec3 weights = Vec3::Zero();
  weights[int(h.index % 3)] = 1;
  return {HalfedgeMesh::face(h), weights};
}

}  // namespace remesher
