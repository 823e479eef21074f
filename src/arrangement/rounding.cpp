// SPDX-License-Identifier: MIT
#include "arrangement/rounding.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "base/place.h"
#include "geometry/triangle_meeting.h"

namespace remesher {

namespace {

class RoundedSurface {
 public:
  RoundedSurface(std::span<const Vec3> positions, std::size_t firstNew, KeptFacets& facets)
      : positions_(positions), firstNew_(firstNew), facets_(facets) {}

  void run() {
    const bool isAnyWelded = weldNew();
    if (isAnyWelded) cancelOpposite();
    const std::vector<Index> needles = findNeedles(isAnyWelded ? 0 : firstNew_);
    if (needles.empty()) return;
    flipAway(needles);
    cancelOpposite();
  }

 private:
  std::array<Index, 3> corners(Index f) const {
    return {facets_.corners[3 * f], facets_.corners[3 * f + 1], facets_.corners[3 * f + 2]};
  }
  void setCorners(Index f, const std::array<Index, 3>& c) {
    std::copy(c.begin(), c.end(), facets_.corners.begin() + std::ptrdiff_t{3} * f);
  }
  std::size_t size() const { return facets_.from.size(); }

  bool weldNew() {
    bool isAnyWelded = false;
    const std::vector<Index> first = weld(positions_);
    for (Index& corner : facets_.corners) {
      if (corner < firstNew_ || first[corner] == corner) continue;
      corner = first[corner];
      isAnyWelded = true;
    }
    return isAnyWelded;
  }

  // Drops triangles with a corner twice, and pairs of triangles that are each other turned over.
  void cancelOpposite() {
    std::map<std::array<Index, 3>, std::vector<Index>> alike;
    std::vector<std::uint8_t> isGone(size(), 0);
    for (Index f = 0; f < size(); ++f) {
      std::array<Index, 3> c = corners(f);
      if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) {
        isGone[f] = 1;
        continue;
      }
      std::sort(c.begin(), c.end());
      std::vector<Index>& others = alike[c];
      const auto opposite = std::find_if(others.begin(), others.end(), [&](Index g) {
        return isEven(corners(f), c) != isEven(corners(g), c);
      });
      if (opposite == others.end()) {
        others.push_back(f);
        continue;
      }
      isGone[f] = isGone[*opposite] = 1;
      others.erase(opposite);
    }
    drop(isGone);
  }

  static bool isEven(const std::array<Index, 3>& c, const std::array<Index, 3>& sorted) {
    const auto at = static_cast<std::size_t>(std::find(c.begin(), c.end(), sorted[0]) - c.begin());
    return c[(at + 1) % 3] == sorted[1];
  }

  void drop(const std::vector<std::uint8_t>& isGone) {
    Index kept = 0;
    for (Index f = 0; f < size(); ++f) {
      if (isGone[f]) continue;
      setCorners(kept, corners(f));
      facets_.from[kept++] = facets_.from[f];
    }
    facets_.from.resize(kept);
    facets_.corners.resize(std::size_t{3} * kept);
  }

  bool isNeedle(Index f) const {
    const std::array<Index, 3> c = corners(f);
    return !hasArea({positions_[c[0]], positions_[c[1]], positions_[c[2]]});
  }

  // Among the facets with a point from this number on: only rounding makes needles.
  std::vector<Index> findNeedles(std::size_t from) const {
    std::vector<Index> needles;
    for (Index f = 0; f < size(); ++f) {
      const std::array<Index, 3> c = corners(f);
      if (std::max({c[0], c[1], c[2]}) >= from && isNeedle(f)) needles.push_back(f);
    }
    return needles;
  }

  double length(Index a, Index b) const { return (positions_[a] - positions_[b]).norm(); }

  // The corner where the longest edge begins.
  std::size_t longestOf(const std::array<Index, 3>& c) const {
    std::size_t k = 0;
    for (std::size_t i = 1; i < 3; ++i)
      if (length(c[i], c[(i + 1) % 3]) > length(c[k], c[(k + 1) % 3])) k = i;
    return k;
  }

  // Needles by their longest edges, the longest first: a flip makes no needle with a longer edge,
  // so that each length is done with in its turn.
  std::pair<double, Index> placeInQueue(Index f) const {
    const std::array<Index, 3> c = corners(f);
    const std::size_t k = longestOf(c);
    return {-length(c[k], c[(k + 1) % 3]), f};
  }

  void attach(Index f) {
    const std::array<Index, 3> c = corners(f);
    for (std::size_t k = 0; k < 3; ++k) trianglesAt_[{c[k], c[(k + 1) % 3]}].push_back(f);
  }
  void detach(Index f) {
    const std::array<Index, 3> c = corners(f);
    for (std::size_t k = 0; k < 3; ++k) std::erase(trianglesAt_[{c[k], c[(k + 1) % 3]}], f);
  }

  // The middle corner of a needle is put into the triangle beyond the longest edge.
  void flipAway(const std::vector<Index>& needles) {
    for (Index f = 0; f < size(); ++f) attach(f);
    std::set<std::pair<double, Index>> queue;
    for (const Index f : needles) queue.insert(placeInQueue(f));
    std::vector<std::uint8_t> isGone(size(), 0);
    while (!queue.empty()) {
      const Index f = queue.begin()->second;
      queue.erase(queue.begin());
      const std::array<Index, 3> c = corners(f);
      const std::size_t k = longestOf(c);
      const Index from = c[k], to = c[(k + 1) % 3], middle = c[(k + 2) % 3];
      const std::vector<Index>& beyond = trianglesAt_[{to, from}];
      if (beyond.empty()) continue;
      const Index g = beyond.front();
      const std::array<Index, 3> d = corners(g);
      const auto at = static_cast<std::size_t>(std::find(d.begin(), d.end(), to) - d.begin());
      const Index apex = d[(at + 2) % 3];
      queue.erase(placeInQueue(g));
      detach(f);
      detach(g);
      if (apex == middle) {
        isGone[f] = isGone[g] = 1;
        continue;
      }
      setCorners(f, {to, middle, apex});
      setCorners(g, {middle, from, apex});
      facets_.from[f] = facets_.from[g];
      for (const Index changed : {f, g}) {
        attach(changed);
        if (isNeedle(changed)) queue.insert(placeInQueue(changed));
      }
    }
    drop(isGone);
  }

  std::span<const Vec3> positions_;
  std::size_t firstNew_;
  KeptFacets& facets_;
  std::map<std::pair<Index, Index>, std::vector<Index>> trianglesAt_;  // per directed edge
};

}  // namespace

void mendRounded(std::span<const Vec3> positions, std::size_t firstNew, KeptFacets& facets) {
  RoundedSurface(positions, firstNew, facets).run();
}

}  // namespace remesher
