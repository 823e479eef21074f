// SPDX-License-Identifier: MIT
#include "contact/touching.h"

#include <algorithm>

#include "geometry/triangle.h"
#include "geometry/triangle_tree.h"

namespace remesher {

namespace {

// Triangles that lie opposite each other face apart by more than this cosine.
constexpr double kOpposite = -0.98;

using Overlap = std::vector<Vec3>;

// What of the overlap lies to the left of the edge from a to b, seen against the normal.
Overlap clipped(const Overlap& overlap, const Vec3& a, const Vec3& b, const Vec3& normal) {
  const Vec3 inwards = normal.cross(b - a);
  Overlap left;
  for (std::size_t i = 0; i < overlap.size(); ++i) {
    const Vec3 &p = overlap[i], &q = overlap[(i + 1) % overlap.size()];
    const double from = inwards.dot(p - a), to = inwards.dot(q - a);
    if (from >= 0) left.push_back(p);
    if ((from > 0 && to < 0) || (from < 0 && to > 0))
      left.push_back(p + from / (from - to) * (q - p));
  }
  return left;
}

double breadthOf(const Overlap& overlap, const Vec3& normal) {
  double doubled = 0, longest = 0;
  for (std::size_t i = 1; i + 1 < overlap.size(); ++i)
    doubled += normal.dot((overlap[i] - overlap[0]).cross(overlap[i + 1] - overlap[0]));
  for (std::size_t i = 0; i < overlap.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      longest = std::max(longest, (overlap[i] - overlap[j]).norm());
  return longest > 0 ? doubled / longest : 0;
}

class TouchSearch {
 public:
  TouchSearch(const BodySoup& soup, const TouchLimits& limits) : soup_(soup), limits_(limits) {
    for (const BodyTriangle& t : soup.triangles)
      indices_.insert(indices_.end(), t.corners.begin(), t.corners.end());
  }

  Touching run() {
    const TriangleTree tree(soup_.points, indices_);
    for (Index t = 0; t < soup_.triangles.size(); ++t) {
      if (!soup_.isClosed[soup_.triangles[t].body]) continue;
      Box box;
      for (std::size_t k = 0; k < 3; ++k) box.extend(soup_.at(t, k));
      box.low.array() -= limits_.near;
      box.high.array() += limits_.near;
      tree.visitOverlapping(box, [&](Index s) {
        if (s < t && soup_.triangles[s].body != soup_.triangles[t].body &&
            soup_.isClosed[soup_.triangles[s].body])
          look(s, t);
      });
    }
    std::sort(found_.pairs.begin(), found_.pairs.end());
    return std::move(found_);
  }

 private:
  Vec3 normal(Index t) const { return unitNormal(soup_.at(t, 0), soup_.at(t, 1), soup_.at(t, 2)); }

  void look(Index s, Index t) {
    const Vec3 up = normal(s);
    if (up.dot(normal(t)) > kOpposite) return;
    Overlap common = {soup_.at(t, 0), soup_.at(t, 2), soup_.at(t, 1)};
    for (std::size_t k = 0; k < 3; ++k)
      common = clipped(common, soup_.at(s, k), soup_.at(s, (k + 1) % 3), up);
    // Of two neighbours on one face the tolerance overlaps.
    constexpr double kNarrow = 4;
    if (common.size() < 3 || breadthOf(common, up) <= kNarrow * limits_.touching) return;
    double low = kInfinity, high = -kInfinity;
    for (const Vec3& p : common) {
      const double height = up.dot(p - soup_.at(s, 0));
      low = std::min(low, height), high = std::max(high, height);
    }
    const double far = std::max(high, -low);
    if (far <= limits_.touching) {
      found_.pairs.emplace_back(s, t);
    } else if (far <= limits_.near && std::max(low, -high) > limits_.touching) {
      // Not a slope that begins where bodies touch.
      ++found_.apart;
      if (far <= found_.gap) return;
      found_.gap = far;
      found_.gapAt = common.front();
    }
  }

  const BodySoup& soup_;
  const TouchLimits& limits_;
  std::vector<Index> indices_;
  Touching found_;
};

}  // namespace

Touching findTouching(const BodySoup& soup, const TouchLimits& limits) {
  return TouchSearch(soup, limits).run();
}

}  // namespace remesher
