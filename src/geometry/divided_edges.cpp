// SPDX-License-Identifier: MIT
#include "geometry/divided_edges.h"

#include <algorithm>

#include "geometry/triangle.h"

namespace remesher {

namespace {

constexpr unsigned sideBit(unsigned side) { return 1U << side; }

// The corners of a triangle and points on its sides, in their order.
class Outline {
 public:
  explicit Outline(std::span<const Vec3> points) : points_(points) {}

  void add(Index point, unsigned sides) {
    places_.push_back({point, sides});
    for (unsigned k = 0; k < 3; ++k) counts_[k] += (sides & sideBit(k)) != 0;
  }

  // Cuts off the ear with the widest smallest angle, again and again.
  std::vector<std::array<Index, 3>> filled() {
    for (std::size_t i = 0; i < places_.size(); ++i) setAngle(i);
    std::vector<std::array<Index, 3>> triangles;
    while (places_.size() > 3) {
      std::size_t best = places_.size();
      double widest = -1;
      for (std::size_t i = 0; i < places_.size(); ++i)
        if (places_[i].angle > widest && leavesArea(i)) widest = places_[i].angle, best = i;
      triangles.push_back(corners(best));
      for (unsigned k = 0; k < 3; ++k) counts_[k] -= (places_[best].sides & sideBit(k)) != 0;
      places_.erase(places_.begin() + std::ptrdiff_t(best));
      setAngle(best % places_.size());
      setAngle((best + places_.size() - 1) % places_.size());
    }
    triangles.push_back(corners(1));
    return triangles;
  }

 private:
  struct Place {
    Index point;
    unsigned sides;     // bits of those that it lies on
    double angle = -1;  // the smallest of its ear; -1 for an ear without area
  };

  const Place& at(std::size_t i) const { return places_[i % places_.size()]; }
  std::array<Index, 3> corners(std::size_t i) const {
    return {at(i + places_.size() - 1).point, at(i).point, at(i + 1).point};
  }

  void setAngle(std::size_t i) {
    const auto [a, b, c] = corners(i);
    const bool isFlat = (at(i + places_.size() - 1).sides & at(i).sides & at(i + 1).sides) != 0;
    places_[i].angle = isFlat ? -1 : minAngle(points_[a], points_[b], points_[c]);
  }

  // Whether the others do not all lie on one side.
  bool leavesArea(std::size_t i) const {
    for (unsigned k = 0; k < 3; ++k)
      if (counts_[k] + 1 == places_.size() && (places_[i].sides & sideBit(k)) == 0) return false;
    return true;
  }

  std::span<const Vec3> points_;
  std::vector<Place> places_;
  std::array<std::size_t, 3> counts_{};  // per side of the places on it
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
