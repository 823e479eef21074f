// SPDX-License-Identifier: MIT
#include "original/surface/boundary_places.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace remesher {

namespace {

// The cost of a chord at the tolerance: above the costs of uneven edges and of moves.
constexpr double kTooFar = 10;

struct Site {
  double arc;
  Vec3 position;
  std::size_t bend, next;  // the chain's first vertices at or beyond arc, and beyond arc
};

double squaredDistanceToChord(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 chord = b - a, fromA = p - a;
  const double length2 = chord.squaredNorm();
  const double share = length2 > 0 ? std::clamp(chord.dot(fromA) / length2, 0.0, 1.0) : 0;
  return (fromA - share * chord).squaredNorm();
}

class Curve {
 public:
  Curve(const OriginalSurface& surface, Index chain)
      : surface_(surface), index_(chain), chain_(surface.curves().chains()[chain]) {}

  Site at(double arc) const {
    const auto& arcs = chain_.arcs;
    const auto bend = std::lower_bound(arcs.begin(), arcs.end(), arc);
    const auto next = std::upper_bound(bend, arcs.end(), arc);
    return {arc, positionAt(surface_, index_, arc), std::size_t(bend - arcs.begin()),
            std::size_t(next - arcs.begin())};
  }

  // Visits the bends between two places: all, or, where they are dense, about `most` of them.
  template <class Visit>
  void forEachBend(const Site& from, const Site& to, std::size_t most, Visit visit) const {
    const std::size_t last = std::max(from.next, to.bend), stride = 1 + (last - from.next) / most;
    for (std::size_t i = from.next; i < last; i += stride)
      visit(chain_.arcs[i], surface_.positions()[chain_.vertices[i]]);
  }

  double distance(const Site& from, const Site& to, std::size_t most) const {
    double farthest2 = 0;
    forEachBend(from, to, most, [&](double, const Vec3& p) {
      farthest2 = std::max(farthest2, squaredDistanceToChord(p, from.position, to.position));
    });
    return std::sqrt(farthest2);
  }

 private:
  const OriginalSurface& surface_;
  const Index index_;
  const Chain& chain_;
};

// Dynamic programming, from the first vertex on, over the places that each vertex may take.
class Placing {
 public:
  Placing(const Curve& curve, std::span<const double> arcs, double tolerance)
      : curve_(curve),
        arcs_(arcs),
        tolerance_(tolerance),
        even_((arcs.back() - arcs.front()) / double(arcs.size() - 1)) {}

  std::vector<double> best() {
    stages_.push_back({{curve_.at(arcs_.front()), 0, 0}});
    for (std::size_t i = 1; i < arcs_.size(); ++i) addStage(i);
    std::vector<double> places(arcs_.size());
    std::size_t k = 0;
    for (std::size_t i = arcs_.size(); i-- > 0; k = stages_[i][k].before)
      places[i] = stages_[i][k].site.arc;
    return places;
  }

 private:
  struct Choice {
    Site site;
    double cost;         // of the best placement up to here
    std::size_t before;  // the choice of the vertex before in that placement
  };

  std::vector<double> candidates(std::size_t i) const {
    std::vector<double> places = {arcs_[i]};
    if (i + 1 == arcs_.size()) return places;
    const double low = arcs_[i - 1], high = arcs_[i + 1];
    for (int k = 1; k < kPlacesBetween; ++k)
      places.push_back(low + (high - low) * k / kPlacesBetween);
    curve_.forEachBend(curve_.at(low), curve_.at(high), kPlacesBetween,
                       [&](double arc, const Vec3&) { places.push_back(arc); });
    return places;
  }

  // Cost of an edge's length; farness() is the cost of its chord's distance from the curve.
  double unevenness(const Site& from, const Site& to) const {
    const double uneven = std::log((to.arc - from.arc) / even_);
    return uneven * uneven;
  }

  double farness(const Site& from, const Site& to) const {
    const double far = curve_.distance(from, to, kPlacesBetween) / tolerance_;
    return far > 1 ? kTooFar * (1 + far) : 0;
  }

  void addStage(std::size_t i) {
    std::vector<Choice> stage;
    const Costs cheapest = cheapestFirst(stages_.back());
    for (const double arc : candidates(i)) stage.push_back(bestWayTo(arc, i, cheapest));
    stages_.push_back(std::move(stage));
  }

  using Costs = std::vector<std::pair<double, std::size_t>>;

  static Costs cheapestFirst(const std::vector<Choice>& stage) {
    Costs costs;
    for (const Choice& choice : stage) costs.emplace_back(choice.cost, costs.size());
    std::sort(costs.begin(), costs.end());
    return costs;
  }

  // Among placements of equal cost the first choice of the vertex before wins.
  Choice bestWayTo(double arc, std::size_t i, const Costs& cheapest) const {
    Choice choice{curve_.at(arc), kInfinity, 0};
    const double move = (arc - arcs_[i]) / even_;
    for (const auto& [costBefore, k] : cheapest) {
      const double moved = costBefore + move * move;
      if (moved > choice.cost) break;
      const Site& before = stages_.back()[k].site;
      if (before.arc >= arc) continue;
      const double uneven = unevenness(before, choice.site);
      if (moved + uneven > choice.cost) continue;
      const double cost = moved + (uneven + farness(before, choice.site));
      if (cost > choice.cost || (cost == choice.cost && k > choice.before)) continue;
      choice.cost = cost;
      choice.before = k;
    }
    return choice;
  }

  const Curve& curve_;
  const std::span<const double> arcs_;
  const double tolerance_, even_;
  std::vector<std::vector<Choice>> stages_;
};

}  // namespace

Vec3 positionAt(const OriginalSurface& surface, Index chain, double arc) {
  return surface.curves().locate(surface.mesh(), surface.positions(), {chain, arc}).position;
}

double chordDistance(const OriginalSurface& surface, Index chain, double from, double to) {
  const Curve curve(surface, chain);
  return curve.distance(curve.at(from), curve.at(to), std::numeric_limits<std::size_t>::max());
}

std::vector<double> placesAlong(const OriginalSurface& surface, Index chain,
                                std::span<const double> arcs, double tolerance) {
  return Placing(Curve(surface, chain), arcs, tolerance).best();
}

}  // namespace remesher
