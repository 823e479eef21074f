// SPDX-License-Identifier: MIT
#include "arrangement/rounding.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <utility>

#include "base/place.h"
#include "geometry/triangle_meeting.h"

namespace remesher {

namespace {

constexpr int kNeedleRounds = 16;

class RoundedSurface {
 public:
  RoundedSurface(std::span<const Vec3> positions, std::size_t firstNew, KeptFacets& facets)
      : positions_(positions), firstNew_(firstNew), facets_(facets) {}

  bool run() {
    if (weldNew()) cancelOpposite();
    for (int round = 0; round < kNeedleRounds; ++round) {
      const std::vector<Index> needles = findNeedles();
      if (needles.empty()) return true;
      flipAway(needles);
      cancelOpposite();
    }
    return findNeedles().empty();
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

  std::vector<Index> findNeedles() const {
    std::vector<Index> needles;
    for (Index f = 0; f < size(); ++f) {
      const std::array<Index, 3> c = corners(f);
      if (std::max({c[0], c[1], c[2]}) < firstNew_) continue;  // as given, and that has an area
      if (!hasArea({positions_[c[0]], positions_[c[1]], positions_[c[2]]})) needles.push_back(f);
    }
    return needles;
  }

  double length(Index a, Index b) const { return (positions_[a] - positions_[b]).norm(); }

  // The middle corner of a needle is put into the triangle beyond the longest edge.
  void flipAway(const std::vector<Index>& needles) {
    std::map<std::pair<Index, Index>, Index> triangleAt;  // by directed edge; the last one
    for (Index f = 0; f < size(); ++f)
      for (std::size_t k = 0; k < 3; ++k) triangleAt[{corners(f)[k], corners(f)[(k + 1) % 3]}] = f;
    std::vector<std::uint8_t> isChanged(size(), 0);
    for (const Index f : needles) {
      const std::array<Index, 3> c = corners(f);
      std::size_t k = 0;
      for (std::size_t i = 1; i < 3; ++i)
        if (length(c[i], c[(i + 1) % 3]) > length(c[k], c[(k + 1) % 3])) k = i;
      const Index from = c[k], to = c[(k + 1) % 3], middle = c[(k + 2) % 3];
      const auto beyond = triangleAt.find({to, from});
      if (beyond == triangleAt.end() || isChanged[f] || isChanged[beyond->second]) continue;
      const Index g = beyond->second;
      const std::array<Index, 3> d = corners(g);
      const auto at = static_cast<std::size_t>(std::find(d.begin(), d.end(), to) - d.begin());
      const Index apex = d[(at + 2) % 3];
      setCorners(f, {to, middle, apex});
      setCorners(g, {middle, from, apex});
      facets_.from[f] = facets_.from[g];
      isChanged[f] = isChanged[g] = 1;
    }
  }

  std::span<const Vec3> positions_;
  std::size_t firstNew_;
  KeptFacets& facets_;
};

}  // namespace

bool mendRounded(std::span<const Vec3> positions, std::size_t firstNew, KeptFacets& facets) {
  return RoundedSurface(positions, firstNew, facets).run();
}

}  // namespace remesher
