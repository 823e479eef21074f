// SPDX-License-Identifier: MIT
#include "contact/divided_edges.h"

#include <algorithm>

#include "geometry/triangle.h"

namespace remesher {

namespace {

constexpr unsigned sideBit(unsigned side) { return 1U << side; }

// The corners of a triangle and points on its sides, in their order.
class Outline {
 public:
  explicit Outline(std::span<const Vec3> points) : points_(points) {}

  void add(Index point, unsigned sides) { places_.push_back({point, sides}); }

  // Cuts off the ear with the widest smallest angle, again and again.
  std::vector<std::array<Index, 3>> filled() {
    std::vector<std::array<Index, 3>> triangles;
    while (places_.size() > 3) {
      std::size_t best = places_.size();
      double widest = -1;
      for (std::size_t i = 0; i < places_.size(); ++i) {
        if (!isEar(i)) continue;
        const auto [a, b, c] = corners(i);
        const double angle = minAngle(points_[a], points_[b], points_[c]);
        if (angle > widest) widest = angle, best = i;
      }
      triangles.push_back(corners(best));
      places_.erase(places_.begin() + std::ptrdiff_t(best));
    }
    triangles.push_back(corners(1));
    return triangles;
  }

 private:
  struct Place {
    Index point;
    unsigned sides;  // bits of those that it lies on
  };

  const Place& at(std::size_t i) const { return places_[i % places_.size()]; }
  std::array<Index, 3> corners(std::size_t i) const {
    return {at(i + places_.size() - 1).point, at(i).point, at(i + 1).point};
  }

  // The outline is convex: an ear is one if it has an area, and if what is left has one.
  bool isEar(std::size_t i) const {
    const std::size_t n = places_.size();
    if ((at(i + n - 1).sides & at(i).sides & at(i + 1).sides) != 0) return false;
    unsigned left = ~0U;
    for (std::size_t j = 1; j < n && left != 0; ++j) left &= at(i + j).sides;
    return left == 0;
  }

  std::span<const Vec3> points_;
  std::vector<Place> places_;
};

}  // namespace

void DividedEdges::add(Index a, Index b, double share, Index point) {
  if (has(a, b, point)) return;
  std::vector<std::pair<double, Index>>& all = points_[std::minmax(a, b)];
  const std::pair<double, Index> entry(a < b ? share : 1 - share, point);
  all.insert(std::upper_bound(all.begin(), all.end(), entry), entry);
}

bool DividedEdges::has(Index a, Index b, Index point) const {
  if (point == a || point == b) return true;
  const auto found = points_.find(std::minmax(a, b));
  return found != points_.end() &&
         std::any_of(found->second.begin(), found->second.end(),
                     [point](const auto& entry) { return entry.second == point; });
}

std::vector<Index> DividedEdges::between(Index a, Index b) const {
  std::vector<Index> result;
  const auto found = points_.find(std::minmax(a, b));
  if (found == points_.end()) return result;
  for (const auto& [share, point] : found->second) result.push_back(point);
  if (a > b) std::reverse(result.begin(), result.end());
  return result;
}

std::vector<std::array<Index, 3>> divided(const std::array<Index, 3>& corners,
                                          const DividedEdges& edges, std::span<const Vec3> points) {
  Outline outline(points);
  for (unsigned k = 0; k < 3; ++k) {
    outline.add(corners[k], sideBit(k) | sideBit((k + 2) % 3));
    for (const Index p : edges.between(corners[k], corners[(k + 1) % 3]))
      outline.add(p, sideBit(k));
  }
  return outline.filled();
}

}  // namespace remesher
