// SPDX-License-Identifier: MIT
#include "original/surface/curvature.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "geometry/extremes.h"
#include "geometry/triangle.h"

namespace remesher {

namespace {

constexpr int kSmoothing = 4;

// The largest turn of the normal per length along an edge at v, on v's own side of every curve.
VertexData<double> sharpestTurns(const OriginalSurface& surface) {
  const HalfedgeMesh& mesh = surface.mesh();
  VertexData<double> result(mesh.vertexCapacity(), 0);  // squared, at first
  for (Index i = 0; i < mesh.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    // Both halfedges of an edge have the same ends, and the same normals there except at a curve.
    if (!mesh.isEdge(h) && !surface.curves().isCurve(h)) continue;
    const Vertex a = mesh.origin(h), b = mesh.tip(h);
    const double length2 = (surface.positions()[b] - surface.positions()[a]).squaredNorm();
    if (!(length2 > 0)) continue;
    const Vec3 turn = surface.cornerNormal(mesh.next(h)) - surface.cornerNormal(h);
    const double sharpness = turn.squaredNorm() / length2;
    for (const Vertex v : {a, b}) result[v] = greatest(result[v], sharpness);
  }
  for (double& turn : result.values()) turn = std::sqrt(turn);
  return result;
}

// Replaces each value by the mean of itself and its neighbours, kSmoothing times. Loops over edges,
// because turning around each vertex would wait for memory at every step.
VertexData<double> smoothed(const HalfedgeMesh& mesh, VertexData<double> values) {
  std::vector<std::array<Vertex, 2>> edges;
  edges.reserve(mesh.halfedgeCapacity() / 2);
  VertexData<double> counts(values.size(), 1);
  for (Index i = 0; i < mesh.halfedgeCapacity(); ++i) {
    const Halfedge h(i);
    if (!mesh.isEdge(h)) continue;
    edges.push_back({mesh.origin(h), mesh.tip(h)});
    for (const Vertex v : edges.back()) ++counts[v];
  }
  for (int k = 0; k < kSmoothing; ++k) {
    VertexData<double> sums = values;
    for (const auto& [a, b] : edges) {
      sums[a] += values[b];
      sums[b] += values[a];
    }
    for (Index i = 0; i < values.size(); ++i) sums[Vertex(i)] /= counts[Vertex(i)];
    values = std::move(sums);
  }
  return values;
}

// A curve itself bends, even if the surfaces on both sides are flat.
void addCurves(const OriginalSurface& surface, VertexData<double>& result) {
  for (const Chain& chain : surface.curves().chains()) {
    if (chain.boundary) continue;  // only one surface lies beside it; its bend is counted already
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

VertexData<double> sharpestBends(const OriginalSurface& surface) {
  VertexData<double> result = sharpestTurns(surface);
  addCurves(surface, result);
  return result;
}

VertexData<double> curvatures(const OriginalSurface& surface) {
  return smoothed(surface.mesh(), sharpestBends(surface));
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
