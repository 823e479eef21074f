// SPDX-License-Identifier: MIT
#include "surface/curvature.h"

#include <algorithm>
#include <cmath>

#include "geometry/triangle.h"

namespace remesher {

namespace {

constexpr int kSmoothing = 4;

// The largest turn of the normal per length along an edge at v, on v's own side of every curve.
VertexData<double> sharpestTurns(const OriginalSurface& surface) {
  const HalfedgeMesh& mesh = surface.mesh();
  VertexData<double> result(mesh.vertexCapacity(), 0);
  for (Index i = 0; i < mesh.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    // Both sides of an edge have the same ends, and the same normals there, except at a curve.
    if (!mesh.isEdge(h) && !surface.curves().isCurve(h)) continue;
    const Vertex a = mesh.origin(h), b = mesh.tip(h);
    const double length = (surface.positions()[b] - surface.positions()[a]).norm();
    if (!(length > 0)) continue;
    const double turn = (surface.cornerNormal(mesh.next(h)) - surface.cornerNormal(h)).norm();
    for (const Vertex v : {a, b}) result[v] = std::max(result[v], turn / length);
  }
  return result;
}

VertexData<double> smoothed(const HalfedgeMesh& mesh, const VertexData<double>& values) {
  VertexData<double> result(values.size(), 0);
  for (Index i = 0; i < mesh.vertexCapacity(); ++i) {
    const Vertex v(i);
    if (!mesh.isAlive(v)) continue;
    double sum = values[v];
    int n = 1;
    mesh.forEachNeighbor(v, [&](Vertex w) {
      sum += values[w];
      ++n;
    });
    result[v] = sum / n;
  }
  return result;
}

// A curve bends too, where the surfaces on both its sides may be flat.
void addCurves(const OriginalSurface& surface, VertexData<double>& result) {
  for (const Chain& chain : surface.curves().chains()) {
    if (chain.boundary) continue;  // beside it lies but one surface, whose own bend counts
    for (std::size_t i = 1; i + 1 < chain.vertices.size(); ++i) {
      const Vec3 at = surface.positions()[chain.vertices[i]];
      const Vec3 in = at - surface.positions()[chain.vertices[i - 1]];
      const Vec3 out = surface.positions()[chain.vertices[i + 1]] - at;
      const double length = 0.5 * (in.norm() + out.norm());
      if (!(length > 0)) continue;
      double& own = result[chain.vertices[i]];
      own = std::max(own, std::atan2(in.cross(out).norm(), in.dot(out)) / length);
    }
  }
}

}  // namespace

VertexData<double> curvatures(const OriginalSurface& surface) {
  VertexData<double> result = sharpestTurns(surface);
  addCurves(surface, result);
  for (int i = 0; i < kSmoothing; ++i) result = smoothed(surface.mesh(), result);
  return result;
}

double meanBend(const OriginalSurface& surface) {
  const HalfedgeMesh& mesh = surface.mesh();
  const auto& p = surface.positions();
  double growth = 0;
  for (Index i = 0; i < mesh.faceCapacity(); ++i) {
    const Halfedge h = mesh.halfedge(Face(i));
    const auto [a, b, c] = mesh.vertices(Face(i));
    const Vec3 ab = p[b] - p[a], ac = p[c] - p[a], across = ab.cross(ac);
    const double twice = across.norm();
    if (!(twice > 0)) continue;
    const Vec3& normal = surface.cornerNormal(h);
    const Vec3 toB = surface.cornerNormal(mesh.next(h)) - normal;
    const Vec3 toC = surface.cornerNormal(mesh.prev(h)) - normal;
    growth += 0.5 * std::abs(across.dot(ab.cross(toC) + toB.cross(ac))) / twice;
  }
  return surface.area() > 0 ? growth / surface.area() : 0;
}

VertexData<double> vertexAreas(const OriginalSurface& surface) {
  const HalfedgeMesh& mesh = surface.mesh();
  VertexData<double> areas(mesh.vertexCapacity(), 0);
  for (Index f = 0; f < mesh.faceCapacity(); ++f) {
    const auto corners = mesh.vertices(Face(f));
    const auto& p = surface.positions();
    const double share = area(p[corners[0]], p[corners[1]], p[corners[2]]) / 3;
    for (const Vertex v : corners) areas[v] += share;
  }
  return areas;
}

}  // namespace remesher
