// SPDX-License-Identifier: MIT
#include "repair/solid/seen_loss.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/distance_sampler.h"

namespace remesher {

namespace {

struct FarPoint {
  Vec3 at;
  double squaredDistance;
};

// The width of the strip along a line of the lattice that is nearer to it than its neighbours are.
double stripAround(const Lattice& lattice, std::size_t axis, std::size_t i) {
  return (lattice.at(axis, i + 1) - lattice.at(axis, i - 1)) / 2;
}

class Survey {
 public:
  Survey(const Lattice& lattice, const SolidSource& source, const Contour& result)
      : lattice_(lattice),
        source_(source),
        tree_(result.points, result.corners),
        squaredBeyond_(lattice.spacing() * lattice.spacing()) {}

  // side: 0 for the first crossing of a line, 1 for the last.
  void add(const EdgeCrossing& c, std::size_t side) {
    const double area = areaAround(c);
    seen_ += area;
    const Vec3 at = placeOf(lattice_, c);
    const double squared = samplers_[side].addBeyond(std::sqrt(squaredBeyond_), at);
    if (squared <= squaredBeyond_) return;
    lost_ += area;
    far_.push_back({at, squared});
  }

  SeenLoss take() {
    SeenLoss loss;
    loss.share = seen_ > 0 ? 100 * lost_ / seen_ : 0;
    loss.beyond = std::sqrt(squaredBeyond_);
    loss.places = places();
    return loss;
  }

 private:
  // The three directions together find each part of the area once: a triangle is crossed by lines
  // along an axis in proportion to its normal's component.
  double areaAround(const EdgeCrossing& c) const {
    const std::array<std::size_t, 3> place = lattice_.place(c.edge / 3);
    double strips = 1;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (axis != c.edge % 3) strips *= stripAround(lattice_, axis, place[axis]);
    const Index* v = &source_.corners[3 * std::size_t{c.triangle}];
    const Vec3 vector =
        areaVector(source_.positions[v[0]], source_.positions[v[1]], source_.positions[v[2]]);
    const double sum = vector.cwiseAbs().sum();
    return sum > 0 ? strips * vector.norm() / sum : 0;
  }

  std::vector<Vec3> places() {
    constexpr std::size_t kMostPlaces = 10;
    constexpr double kCellsApart = 10;
    const double apart = kCellsApart * lattice_.spacing();
    std::stable_sort(far_.begin(), far_.end(), [](const FarPoint& a, const FarPoint& b) {
      return a.squaredDistance > b.squaredDistance;
    });
    std::vector<Vec3> places;
    for (const FarPoint& point : far_) {
      if (places.size() == kMostPlaces) break;
      const bool isNew = std::all_of(places.begin(), places.end(), [&](const Vec3& place) {
        return (place - point.at).squaredNorm() > apart * apart;
      });
      if (isNew) places.push_back(point.at);
    }
    return places;
  }

  const Lattice& lattice_;
  const SolidSource& source_;
  const TriangleTree tree_;
  const double squaredBeyond_;
  double seen_ = 0, lost_ = 0;
  std::array<DistanceSampler, 2> samplers_{DistanceSampler(tree_), DistanceSampler(tree_)};
  std::vector<FarPoint> far_;
};

}  // namespace

SeenLoss seenLoss(const Lattice& lattice, const SolidSource& source,
                  std::span<const EdgeCrossing> crossings, const Contour& result) {
  if (result.corners.empty()) return {};
  Survey survey(lattice, source, result);
  forEachCrossedLine(lattice, crossings, [&](const CrossedLine& line) {
    survey.add(line.crossings.front(), 0);
    if (line.crossings.size() > 1) survey.add(line.crossings.back(), 1);
  });
  return survey.take();
}

}  // namespace remesher
