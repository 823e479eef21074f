// SPDX-License-Identifier: MIT
#include "repair/stitch.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "base/fires.h"
#include "geometry/divided_edges.h"
#include "geometry/mesh_triangle.h"
#include "geometry/triangle_meeting.h"
#include "geometry/triangle_tree.h"
#include "mesh/attribute_mix.h"
#include "mesh/joining.h"
#include "mesh/welding.h"

namespace remesher {

namespace {

// Shares of the diagonal: from single precision's step to the width of a crack that is not seen.
constexpr std::array kWeldingDistances = {1e-7, 1e-6, 1e-5, 1e-4};
// Of cracks that are hardly seen. They are closed only if few open edges are left, else they may be
// meant; the narrowest distance is taken that closes as many as the wider ones.
constexpr std::array kWideDistances = {1e-3, 3e-4, 1e-4, 1e-5};
constexpr double kMostLeftOfWide = 0.1;
constexpr int kMostPasses = 4;

class Stitcher {
 public:
  Stitcher(TriangleMesh& mesh, double tolerance)
      : mesh_(mesh), tolerance_(tolerance * diagonalOf(mesh)), mix_(mesh) {}

  // One pass. inputs: per triangle the input's, kept up. Returns whether any triangle was divided.
  bool pass(std::vector<Index>& inputs) {
    const Welding welding(mesh_);
    const std::vector<char> isOpen = openVerticesOf(mesh_, welding);
    std::vector<Index> points;
    for (Index v = 0; v < isOpen.size(); ++v)
      if (isOpen[v] && welding.first[v] == v) points.insert(points.end(), {v, v, v});
    if (points.empty()) return false;
    const std::vector<Vec3> positions = mesh_.positions;
    const TriangleTree tree(positions, points);
    const DividedEdges edges = dividedAt(openEdgesOf(welding), tree, points);
    return !edges.empty() && divide(edges, inputs);
  }

 private:
  // Per halfedge of the mesh whether it is alone at its edge.
  std::vector<char> openEdgesOf(const Welding& welding) const {
    const std::vector<Index> given = welding.triangles(mesh_);
    std::vector<char> isOpen(mesh_.indices.size(), 0);
    welding.forEachEdge([&](std::span<const Index> edge) {
      if (edge.size() == 1) isOpen[3 * std::size_t{given[edge[0] / 3]} + edge[0] % 3] = 1;
    });
    return isOpen;
  }

  // The open edges divided by new vertices where open vertices lie on them.
  DividedEdges dividedAt(const std::vector<char>& isOpen, const TriangleTree& tree,
                         const std::vector<Index>& points) {
    DividedEdges edges;
    std::vector<std::pair<double, Index>> found;  // the place along the edge, the open vertex
    for (Index h = 0; h < isOpen.size(); ++h) {
      if (!isOpen[h]) continue;
      const Vec3 &a = position(h), &b = position(nextCorner(h));
      Box box;
      for (const Vec3& p : {a, b}) {
        box.extend(p - Vec3::Constant(tolerance_));
        box.extend(p + Vec3::Constant(tolerance_));
      }
      found.clear();
      tree.visitOverlapping(box, [&](Index point) {
        const Index v = points[3 * std::size_t{point}];
        if (const double along = alongEdge(mesh_.positions[v], a, b); along > 0)
          found.emplace_back(along, v);
      });
      std::sort(found.begin(), found.end());
      for (const auto& [along, v] : found)
        edges.add(mesh_.indices[h], mesh_.indices[nextCorner(h)], along, newVertex(h, along, v));
    }
    return edges;
  }

  const Vec3& position(Index corner) const { return mesh_.positions[mesh_.indices[corner]]; }

  // The place between the ends of an edge that p lies on; 0 if it does not.
  double alongEdge(const Vec3& p, const Vec3& a, const Vec3& b) const {
    const Vec3 edge = b - a;
    const double length = edge.norm(), along = (p - a).dot(edge) / (length * length);
    const bool isBetween = along * length > tolerance_ && (1 - along) * length > tolerance_;
    return isBetween && (p - a - along * edge).norm() <= tolerance_ ? along : 0;
  }

  // Returns whether any triangle was divided. These come last.
  bool divide(const DividedEdges& edges, std::vector<Index>& inputs) {
    const TriangleMesh before{
        {}, std::exchange(mesh_.indices, {}), std::exchange(mesh_.groups, {}), {}};
    const std::vector<Index> all = std::exchange(inputs, {});
    const auto append = [&](Index t, const std::vector<std::array<Index, 3>>& made) {
      for (const auto& v : made) mesh_.indices.insert(mesh_.indices.end(), v.begin(), v.end());
      inputs.resize(mesh_.triangleCount(), all[t]);
      if (!before.groups.empty()) mesh_.groups.resize(mesh_.triangleCount(), before.groups[t]);
    };
    std::vector<std::pair<Index, std::vector<std::array<Index, 3>>>> last;
    for (Index t = 0; t < before.triangleCount(); ++t) {
      const Index* v = &before.indices[3 * std::size_t{t}];
      auto made = divided({v[0], v[1], v[2]}, edges, mesh_.positions);
      if (made.size() == 1)
        append(t, made);
      else
        last.emplace_back(t, std::move(made));
    }
    for (const auto& [t, made] : last) append(t, made);
    return !last.empty();
  }

  // At the place of an open vertex, with the attributes of the edge there.
  Index newVertex(Index h, double along, Index at) {
    const Index next = nextCorner(h), last = nextCorner(next);
    const Vec3 normal = areaVector(position(h), position(next), position(last));
    mix_.append({{mesh_.indices[h], mesh_.indices[next], mesh_.indices[last]},
                 {1 - along, along, 0},
                 normal},
                mesh_.attributes);
    mesh_.positions.push_back(Vec3(mesh_.positions[at]));
    return Index(mesh_.positions.size() - 1);
  }

  TriangleMesh& mesh_;
  const double tolerance_;
  const AttributeMix mix_;
};

// Welds the open vertices that are so near to each other.
bool isWelded(TriangleMesh& mesh, double share) {
  const Welding before(mesh);
  joinNear(mesh, share * diagonalOf(mesh), openVerticesOf(mesh, before));
  return Welding(mesh).corners.size() == before.corners.size();
}

// Leaves out the triangles without area.
std::vector<Index> keepAreas(TriangleMesh& mesh) {
  std::vector<Index> inputs, indices, groups;
  for (Index t = 0; t < mesh.triangleCount(); ++t) {
    const Index* v = &mesh.indices[3 * std::size_t{t}];
    if (!hasArea(cornersOf(mesh, t))) continue;
    inputs.push_back(t);
    indices.insert(indices.end(), v, v + 3);
    if (!mesh.groups.empty()) groups.push_back(mesh.groups[t]);
  }
  mesh.indices = std::move(indices), mesh.groups = std::move(groups);
  return inputs;
}

}  // namespace

std::size_t countUnbalancedEdges(const Welding& welding) {
  const auto& twins = welding.twins;
  std::size_t count = std::size_t(std::count(twins.begin(), twins.end(), kNone));
  if (!twins.empty()) return count;
  welding.forEachEdge([&](std::span<const Index> edge) {
    long sum = 0;
    for (const Index h : edge) sum += welding.corners[h] < welding.corners[nextCorner(h)] ? 1 : -1;
    count += sum != 0;
  });
  return count;
}

bool haveAreas(const TriangleMesh& mesh) {
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t)
    if (!hasArea(cornersOf(mesh, t))) return false;
  return true;
}

void weldOpenVertices(TriangleMesh& mesh) {
  const Welding before(mesh);
  std::size_t fewest = countUnbalancedEdges(before);
  const std::vector<char> isOpen = openVerticesOf(mesh, before);
  const double diagonal = diagonalOf(mesh);
  TriangleMesh best = mesh;
  for (const double share : kWeldingDistances) {
    if (fewest == 0) break;
    TriangleMesh welded{mesh.positions, mesh.indices, {}, {}};
    joinNear(welded, share * diagonal, isOpen);
    const Welding after(welded);
    if (after.corners.size() < before.corners.size()) break;
    const std::size_t open = countUnbalancedEdges(after);
    if (open >= fewest) continue;
    fewest = open;
    best.positions = std::move(welded.positions);
  }
  mesh.positions = std::move(best.positions);
}

std::vector<Index> stitchOpenEdges(TriangleMesh& mesh, double tolerance) {
  mesh.isQuads = false;
  std::vector<Index> inputs = keepAreas(mesh);
  for (int pass = 0; pass < kMostPasses; ++pass)
    if (!Stitcher(mesh, tolerance).pass(inputs)) return inputs;
  fires("stitch: most passes");
  return inputs;
}

bool closeWideCracks(TriangleMesh& mesh) {
  const std::size_t before = countUnbalancedEdges(mesh);
  double fewest = kMostLeftOfWide * double(before);
  TriangleMesh best;
  for (const double share : kWideDistances) {
    TriangleMesh closed = mesh;
    if (before == 0 || !isWelded(closed, share)) continue;
    stitchOpenEdges(closed, share);
    const double open = double(countUnbalancedEdges(closed));
    if (open > fewest) break;
    fewest = open;
    best = std::move(closed);
  }
  if (best.indices.empty()) return false;
  fires("stitch: wide cracks closed");
  mesh = std::move(best);
  return true;
}

}  // namespace remesher
