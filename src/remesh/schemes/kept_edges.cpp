// SPDX-License-Identifier: MIT
#include "remesh/schemes/kept_edges.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/options.h"
#include "base/place.h"
#include "geometry/distance_sampler.h"
#include "geometry/triangle.h"

namespace remesher {

namespace {

// An edge of the other surface counts as sharp from this share of the feature angle on: chords of a
// rim bend a little less than the rim.
constexpr double kHardlyBlunter = 0.75;

// The edges of two triangles whose normals part by so much; triangles without area have none.
std::vector<Halfedge> sharpEdgesOf(const Surface& surface, double angle) {
  const HalfedgeMesh& m = surface.mesh;
  const auto normal = [&](Halfedge h) {
    const auto [a, b, c] = m.vertices(m.face(h));
    return areaVector(surface.positions[a], surface.positions[b], surface.positions[c]);
  };
  std::vector<Halfedge> edges;
  for (Index i = 0; i < m.halfedgeCapacity(); ++i) {
    const Halfedge h(i), t = m.isEdge(h) ? m.twin(h) : Halfedge();
    if (!t) continue;
    const Vec3 one = normal(h), other = normal(t);
    if (one.dot(other) < std::cos(angle) * one.norm() * other.norm()) edges.push_back(h);
  }
  return edges;
}

// With the boundaries.
std::vector<Halfedge> rimsOf(const Surface& surface, double angle) {
  std::vector<Halfedge> rims = sharpEdgesOf(surface, angle);
  for (Index i = 0; i < surface.mesh.halfedgeCapacity(); ++i)
    if (surface.mesh.isAlive(Halfedge(i)) && surface.mesh.isBoundary(Halfedge(i)))
      rims.emplace_back(i);
  return rims;
}

// Edges as triangles whose second and third corner are one.
struct EdgeTree {
  std::vector<Vec3> ends;
  std::vector<Index> corners;
  TriangleTree tree;

  EdgeTree(const Surface& surface, const std::vector<Halfedge>& edges)
      : ends(endsOf(surface, edges)), corners(cornersOf(edges.size())), tree(ends, corners) {}
  EdgeTree(const EdgeTree&) = delete;  // the tree refers to the lists beside it
  EdgeTree& operator=(const EdgeTree&) = delete;

  static std::vector<Vec3> endsOf(const Surface& surface, const std::vector<Halfedge>& edges) {
    std::vector<Vec3> ends;
    for (const Halfedge h : edges)
      for (const Vertex v : {surface.mesh.origin(h), surface.mesh.tip(h)})
        ends.push_back(surface.positions[v]);
    return ends;
  }

  static std::vector<Index> cornersOf(std::size_t edges) {
    std::vector<Index> corners;
    for (Index i = 0; i < edges; ++i) corners.insert(corners.end(), {2 * i, 2 * i + 1, 2 * i + 1});
    return corners;
  }
};

double volumeOf(const Surface& surface, const Vec3& from) {
  double sum = 0;
  for (Index i = 0; i < surface.mesh.faceCapacity(); ++i) {
    if (!surface.mesh.isAlive(Face(i))) continue;
    const auto [a, b, c] = surface.mesh.vertices(Face(i));
    const auto& p = surface.positions;
    sum += (p[a] - from).dot((p[b] - from).cross(p[c] - from)) / 6;
  }
  return sum;
}

bool isClosed(const HalfedgeMesh& mesh) {
  for (Index i = 0; i < mesh.halfedgeCapacity(); ++i)
    if (mesh.isAlive(Halfedge(i)) && mesh.isBoundary(Halfedge(i))) return false;
  return true;
}

}  // namespace

double shareOfSharpEdges(const Surface& original, const Surface& made, double near) {
  const std::vector<Halfedge> wanted = sharpEdgesOf(original, radians(kFeatureAngle));
  const EdgeTree found(made, sharpEdgesOf(made, kHardlyBlunter * radians(kFeatureAngle)));
  if (wanted.empty()) return 1;
  if (found.ends.empty()) return 0;
  double all = 0, kept = 0;
  for (const Halfedge h : wanted) {
    const Vec3 &a = original.positions[original.mesh.origin(h)],
               &b = original.positions[original.mesh.tip(h)];
    const double length = (b - a).norm();
    const double steps = std::max(1.0, std::ceil(length / (2 * near)));
    for (double k = 0.5; k < steps; ++k) {
      const double squared = found.tree.nearest(a + k / steps * (b - a)).squaredDistance;
      if (squared <= near * near) kept += length / steps;
      all += length / steps;
    }
  }
  return kept / all;
}

double farthestOfRims(const Surface& surface, const MeshTree& other) {
  const HalfedgeMesh& m = surface.mesh;
  DistanceSampler sampler(other.triangles());
  for (const Halfedge h : rimsOf(surface, kHardlyBlunter * radians(kFeatureAngle))) {
    const Vec3 &a = surface.positions[m.origin(h)], &b = surface.positions[m.tip(h)];
    for (const Vec3& p : {a, Vec3(0.5 * (a + b)), b}) sampler.addBeyond(sampler.farthest(), p);
  }
  return sampler.farthest();
}

double changeOfVolume(const Surface& original, const Surface& made) {
  if (!isClosed(original.mesh)) return 0;
  const Vec3 from = original.positions.values().front();
  const double own = volumeOf(original, from);
  return own == 0 ? 0 : (volumeOf(made, from) - own) / own;
}

std::size_t countSharpCorners(const Surface& surface) {
  const HalfedgeMesh& m = surface.mesh;
  struct Lines {
    int count = 0;
    Vec3 ways = Vec3::Zero();  // sum of the directions along them
  };
  VertexData<Lines> lines(m.vertexCapacity());
  for (const Halfedge h : rimsOf(surface, radians(kFeatureAngle))) {
    const Vertex a = m.origin(h), b = m.tip(h);
    const Vec3 way = (surface.positions[b] - surface.positions[a]).normalized();
    lines[a] = {lines[a].count + 1, lines[a].ways + way};
    lines[b] = {lines[b].count + 1, lines[b].ways - way};
  }
  // Two directions whose lines bend by an angle have a sum of twice the sine of half of it.
  const double least = 2 * std::sin(radians(kFeatureAngle) / 2);
  std::vector<Vec3> corners;
  for (Index i = 0; i < m.vertexCapacity(); ++i) {
    const auto& [count, ways] = lines[Vertex(i)];
    if (count != 0 && (count != 2 || ways.norm() >= least))
      corners.push_back(surface.positions[Vertex(i)]);
  }
  return countPlaces(corners);
}

}  // namespace remesher
