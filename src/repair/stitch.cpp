// SPDX-License-Identifier: MIT
#include "repair/stitch.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "base/fires.h"
#include "geometry/triangle_meeting.h"
#include "geometry/triangle_tree.h"
#include "mesh/attribute_mix.h"
#include "mesh/joining.h"
#include "mesh/welding.h"

namespace remesher {

namespace {

// Shares of the diagonal: from single precision's step to the width of a crack that is not seen.
constexpr std::array kWeldingDistances = {1e-7, 1e-6, 1e-5, 1e-4};
// A vertex this near to an edge, as a share of the diagonal, lies on it.
constexpr double kOnEdge = 1e-6;
constexpr int kMostPasses = 4;

// Per vertex whether it lies on an open edge.
std::vector<char> openVerticesOf(const TriangleMesh& mesh, const Welding& welding) {
  std::vector<char> isOpenPlace(mesh.positions.size(), 0);
  welding.forEachEdge([&](std::span<const Index> edge) {
    if (edge.size() != 1) return;
    isOpenPlace[welding.corners[edge[0]]] = 1;
    isOpenPlace[welding.corners[nextCorner(edge[0])]] = 1;
  });
  std::vector<char> isOpen(mesh.positions.size());
  for (Index v = 0; v < isOpen.size(); ++v) isOpen[v] = isOpenPlace[welding.first[v]];
  return isOpen;
}

std::size_t countUnbalanced(const Welding& welding) {
  std::size_t count = 0;
  welding.forEachEdge([&](std::span<const Index> edge) {
    long sum = 0;
    for (const Index h : edge) sum += welding.corners[h] < welding.corners[nextCorner(h)] ? 1 : -1;
    count += sum != 0;
  });
  return count;
}

// Where an open vertex lies along an edge.
struct Junction {
  double along;  // 0 to 1
  Index vertex;

  bool operator<(const Junction& other) const {
    return along != other.along ? along < other.along : vertex < other.vertex;
  }
};

using Junctions = std::array<std::vector<Junction>, 3>;  // per edge of a triangle

class Stitcher {
 public:
  explicit Stitcher(TriangleMesh& mesh)
      : mesh_(mesh), tolerance_(kOnEdge * diagonalOf(mesh)), mix_(mesh) {}

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
    const std::vector<Junctions> junctions = junctionsOn(openEdgesOf(welding), tree, points);
    return divide(junctions, inputs);
  }

 private:
  // Per halfedge of the mesh whether it is alone at its edge.
  std::vector<char> openEdgesOf(const Welding& welding) const {
    std::vector<Index> given;  // per triangle with three places its number in the mesh
    for (Index t = 0; t < mesh_.triangleCount(); ++t) {
      const Index* v = &mesh_.indices[3 * std::size_t{t}];
      const Index a = welding.first[v[0]], b = welding.first[v[1]], c = welding.first[v[2]];
      if (a != b && b != c && c != a) given.push_back(t);
    }
    std::vector<char> isOpen(mesh_.indices.size(), 0);
    welding.forEachEdge([&](std::span<const Index> edge) {
      if (edge.size() == 1) isOpen[3 * std::size_t{given[edge[0] / 3]} + edge[0] % 3] = 1;
    });
    return isOpen;
  }

  std::vector<Junctions> junctionsOn(const std::vector<char>& isOpen, const TriangleTree& tree,
                                     const std::vector<Index>& points) const {
    std::vector<Junctions> junctions(mesh_.triangleCount());
    for (Index h = 0; h < isOpen.size(); ++h) {
      if (!isOpen[h]) continue;
      const Vec3& a = mesh_.positions[mesh_.indices[h]];
      const Vec3& b = mesh_.positions[mesh_.indices[nextCorner(h)]];
      Box box;
      for (const Vec3& p : {a, b}) {
        box.extend(p - Vec3::Constant(tolerance_));
        box.extend(p + Vec3::Constant(tolerance_));
      }
      std::vector<Junction>& found = junctions[h / 3][h % 3];
      tree.visitOverlapping(box, [&](Index point) {
        const Index v = points[3 * std::size_t{point}];
        if (const double along = alongEdge(mesh_.positions[v], a, b); along > 0)
          found.push_back({along, v});
      });
      std::sort(found.begin(), found.end());
    }
    return junctions;
  }

  // The place between the ends of an edge that p lies on; 0 if it does not.
  double alongEdge(const Vec3& p, const Vec3& a, const Vec3& b) const {
    const Vec3 edge = b - a;
    const double length = edge.norm(), along = (p - a).dot(edge) / (length * length);
    const bool isBetween = along * length > tolerance_ && (1 - along) * length > tolerance_;
    return isBetween && (p - a - along * edge).norm() <= tolerance_ ? along : 0;
  }

  bool divide(const std::vector<Junctions>& junctions, std::vector<Index>& inputs) {
    const std::vector<Index> triangles = std::exchange(mesh_.indices, {});
    const std::vector<Index> groups = std::exchange(mesh_.groups, {}),
                             all = std::exchange(inputs, {});
    for (const bool isDivided : {false, true})
      for (Index t = 0; t < junctions.size(); ++t) {
        const Junctions& own = junctions[t];
        if (isDivided == (own[0].empty() && own[1].empty() && own[2].empty())) continue;
        const Index* v = &triangles[3 * std::size_t{t}];
        append({v[0], v[1], v[2]}, own);
        inputs.resize(mesh_.triangleCount(), all[t]);
        if (!groups.empty()) mesh_.groups.resize(mesh_.triangleCount(), groups[t]);
      }
    return mesh_.indices.size() > triangles.size();
  }

  // The triangle, divided at its junctions: a fan from the corner opposite to an edge with
  // junctions, whose first and last triangles have the other two edges.
  void append(std::array<Index, 3> corners, Junctions junctions) {
    std::size_t edge = 0;
    while (edge < 3 && junctions[edge].empty()) ++edge;
    if (edge == 3) {
      mesh_.indices.insert(mesh_.indices.end(), corners.begin(), corners.end());
      return;
    }
    const Index from = corners[edge], to = corners[(edge + 1) % 3], apex = corners[(edge + 2) % 3];
    std::vector<Index> along = {from};
    for (const Junction& junction : junctions[edge])
      along.push_back(between({from, to, apex}, junction));
    along.push_back(to);
    for (std::size_t i = 0; i + 1 < along.size(); ++i) {
      Junctions own;
      if (i + 2 == along.size()) own[1] = std::move(junctions[(edge + 1) % 3]);
      if (i == 0) own[2] = std::move(junctions[(edge + 2) % 3]);
      append({along[i], along[i + 1], apex}, std::move(own));
    }
  }

  // A new vertex at the junction on the first edge of a triangle.
  Index between(const std::array<Index, 3>& corners, const Junction& junction) {
    const Vec3 weights(1 - junction.along, junction.along, 0);
    const Vec3 normal = areaVector(mesh_.positions[corners[0]], mesh_.positions[corners[1]],
                                   mesh_.positions[corners[2]]);
    mix_.append({corners, weights, normal}, mesh_.attributes);
    mesh_.positions.push_back(Vec3(mesh_.positions[junction.vertex]));
    return Index(mesh_.positions.size() - 1);
  }

  TriangleMesh& mesh_;
  const double tolerance_;
  const AttributeMix mix_;
};

// Leaves out the triangles without area.
std::vector<Index> keepAreas(TriangleMesh& mesh) {
  std::vector<Index> inputs, indices, groups;
  for (Index t = 0; t < mesh.triangleCount(); ++t) {
    const Index* v = &mesh.indices[3 * std::size_t{t}];
    if (!hasArea({mesh.positions[v[0]], mesh.positions[v[1]], mesh.positions[v[2]]})) continue;
    inputs.push_back(t);
    indices.insert(indices.end(), v, v + 3);
    if (!mesh.groups.empty()) groups.push_back(mesh.groups[t]);
  }
  mesh.indices = std::move(indices), mesh.groups = std::move(groups);
  return inputs;
}

}  // namespace

std::size_t countUnbalancedEdges(const TriangleMesh& mesh) {
  return countUnbalanced(Welding(mesh));
}

bool haveAreas(const TriangleMesh& mesh) {
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
    if (!hasArea({mesh.positions[mesh.indices[i]], mesh.positions[mesh.indices[i + 1]],
                  mesh.positions[mesh.indices[i + 2]]}))
      return false;
  return true;
}

void weldOpenVertices(TriangleMesh& mesh) {
  const Welding before(mesh);
  std::size_t fewest = countUnbalanced(before);
  const std::vector<char> isOpen = openVerticesOf(mesh, before);
  const double diagonal = diagonalOf(mesh);
  TriangleMesh best = mesh;
  for (const double share : kWeldingDistances) {
    if (fewest == 0) break;
    TriangleMesh welded{mesh.positions, mesh.indices, {}, {}};
    joinNear(welded, share * diagonal, isOpen);
    const Welding after(welded);
    if (after.corners.size() < before.corners.size()) break;
    const std::size_t open = countUnbalanced(after);
    if (open >= fewest) continue;
    fewest = open;
    best.positions = std::move(welded.positions);
  }
  mesh.positions = std::move(best.positions);
}

std::vector<Index> stitchOpenEdges(TriangleMesh& mesh) {
  mesh.isQuads = false;
  std::vector<Index> inputs = keepAreas(mesh);
  for (int pass = 0; pass < kMostPasses; ++pass)
    if (!Stitcher(mesh).pass(inputs)) return inputs;
  fires("stitch: most passes");
  return inputs;
}

}  // namespace remesher
