// SPDX-License-Identifier: MIT
#include "repair/touching_faces.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/fires.h"
#include "base/place.h"
#include "contact/common_faces.h"
#include "geometry/triangle.h"
#include "geometry/triangle_tree.h"
#include "mesh/coordinate_step.h"

namespace remesher {

namespace {

constexpr double kMoved = 4;  // a triangle's middle from where it was, at most: ratio to the gap

class Joining {
 public:
  Joining(const TriangleMesh& bodies, double gap)
      : bodies_(bodies), gap_(gap), tree_(bodies.positions, bodies.indices) {
    result_.mesh = bodies;
    result_.mesh.indices.clear(), result_.mesh.groups.clear();
    result_.mesh.isQuads = false;
  }

  std::optional<JoinedFaces> run() {
    const std::vector<Index> pieces(bodies_.triangleCount(), 0);
    const BodyComplex complex = complexOf(bodies_, pieces, {gap_, gap_});
    if (complex.touching.pairs.empty()) return std::nullopt;
    const std::vector<Vec3> places = placesOf(complex);
    std::vector<Triangle> triangles;
    std::vector<Index> parents;
    for (const ComplexTriangle& t : complex.triangles) {
      if (t.other.body != kNone) continue;
      triangles.push_back({places[t.corners[0]], places[t.corners[1]], places[t.corners[2]]});
      parents.push_back(parentOf(triangles.back()));
      if (parents.back() == kNone) return std::nullopt;
    }
    std::vector<Index> order(triangles.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return parents[a] < parents[b]; });
    for (const Index t : order) add(triangles[t], parents[t]);
    return std::move(result_);
  }

 private:
  static bool isBefore(const Vec3& p, const Vec3& q) {
    return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end());
  }

  // The complex's points; new ones are rounded, those of the bodies are not.
  std::vector<Vec3> placesOf(const BodyComplex& complex) const {
    std::vector<Vec3> given = bodies_.positions;
    std::sort(given.begin(), given.end(), isBefore);
    std::vector<Vec3> places = complex.points;
    for (Vec3& p : places) {
      if (std::binary_search(given.begin(), given.end(), p, isBefore)) continue;
      p = canonicalPlace(p);
      if (bodies_.isSingle) p = inSingle(p, bodies_.frame);
    }
    return places;
  }

  // The nearest triangle of those that face the same way.
  Index parentOf(const Triangle& at) const {
    const Vec3 middle = (at[0] + at[1] + at[2]) / 3, normal = areaVector(at[0], at[1], at[2]);
    Box box;
    box.extend(middle.array() - kMoved * gap_);
    box.extend(middle.array() + kMoved * gap_);
    std::pair<double, Index> best{kInfinity, kNone};
    tree_.visitOverlapping(box, [&](Index t) {
      const auto [a, b, c] = tree_.corners(t);
      if (areaVector(a, b, c).dot(normal) <= 0) return;
      best = std::min(best, {(closestPoint(middle, a, b, c) - middle).squaredNorm(), t});
    });
    return best.second;
  }

  void add(const Triangle& at, Index parent) {
    const Index* v = &bodies_.indices[3 * std::size_t{parent}];
    for (const Vec3& p : at) {
      const auto own = std::find_if(v, v + 3, [&](Index i) { return bodies_.positions[i] == p; });
      if (own != v + 3) {
        result_.mesh.indices.push_back(*own);
        continue;
      }
      result_.mesh.indices.push_back(Index(result_.mesh.positions.size()));
      result_.mesh.positions.push_back(p);
    }
    if (!bodies_.groups.empty()) result_.mesh.groups.push_back(bodies_.groups[parent]);
    result_.parents.push_back(parent);
  }

  const TriangleMesh& bodies_;
  const double gap_;
  const TriangleTree tree_;
  JoinedFaces result_;
};

}  // namespace

std::optional<JoinedFaces> withFacesJoined(const TriangleMesh& bodies, double steps) {
  // Flat faces get other triangles, in which attributes would no longer be linear.
  if (!bodies.attributes.empty()) return std::nullopt;
  std::vector<Vec3> used;
  for (const Index v : bodies.indices) used.push_back(bodies.positions[v]);
  return Joining(bodies, steps * coordinateStep(used)).run();
}

}  // namespace remesher
