// SPDX-License-Identifier: MIT
#include "arrangement/parted_fans.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "base/fires.h"

namespace remesher {

namespace {

using Pair = std::pair<Index, Index>;
using FanCorners = std::vector<Index>;  // places in a list of indices

struct Fan {
  Index vertex, own;  // own: the point that the fan gets
  FanCorners corners;
  Vec3 way;  // from the vertex to the middle of the fan's other corners
  bool isParted = false;
};

// How far a corner goes on its way: the first of these that parts the fans, else nowhere.
constexpr std::array kShares = {0x1p-10, 0x1p-7, 0x1p-4, 0.0};

Index after(Index corner, Index steps) { return corner - corner % 3 + (corner + steps) % 3; }

// The wanted vertices with their corners, ascending.
std::vector<Pair> cornersOf(const std::vector<Index>& indices,
                            const std::vector<std::uint8_t>& isWanted) {
  std::vector<Pair> result;
  for (Index c = 0; c < indices.size(); ++c)
    if (indices[c] < isWanted.size() && isWanted[indices[c]]) result.emplace_back(indices[c], c);
  std::sort(result.begin(), result.end());
  return result;
}

// Those of the first vertex in the list.
std::span<const Pair> firstOf(std::span<const Pair> corners) {
  std::size_t count = 0;
  while (count < corners.size() && corners[count].first == corners[0].first) ++count;
  return corners.first(count);
}

// The fans of triangles that follow each other around a vertex; none where one of its edges has
// more than two triangles.
std::vector<FanCorners> fansOf(const std::vector<Index>& indices, std::span<const Pair> around) {
  std::vector<Pair> left;  // the next vertex in the triangle, and the corner
  for (const auto& [vertex, c] : around) left.emplace_back(indices[after(c, 1)], c);
  std::sort(left.begin(), left.end());
  for (std::size_t i = 1; i < left.size(); ++i)
    if (left[i].first == left[i - 1].first) return {};
  std::vector<FanCorners> fans;
  while (!left.empty()) {
    FanCorners& fan = fans.emplace_back();
    for (auto at = left.begin(); at != left.end();) {
      fan.push_back(at->second);
      left.erase(at);
      const Index last = indices[after(fan.back(), 2)];
      at = std::lower_bound(left.begin(), left.end(), Pair{last, 0});
      if (at != left.end() && at->first != last) break;
    }
  }
  return fans;
}

// The given vertices of triangles that are not their parents.
std::vector<std::uint8_t> verticesOfCuts(const ArrangementResult& result,
                                         const ArrangementInput& input) {
  std::vector<std::uint8_t> isOfCut(input.positions.size(), 0);
  for (std::size_t f = 0; f < result.triangles.size(); ++f) {
    const Index* own = &result.indices[3 * f];
    if (std::equal(own, own + 3, &input.indices[3 * std::size_t{result.triangles[f].parent}]))
      continue;
    for (int k = 0; k < 3; ++k)
      if (own[k] < isOfCut.size()) isOfCut[own[k]] = 1;
  }
  return isOfCut;
}

// Whether each triangle at the vertex comes from one that has it as a corner.
bool isFold(const ArrangementResult& result, const ArrangementInput& input,
            std::span<const Pair> around) {
  for (const auto& [vertex, c] : around) {
    const Index* parent = &input.indices[3 * std::size_t{result.triangles[c / 3].parent}];
    if (std::find(parent, parent + 3, vertex) == parent + 3) return false;
  }
  return true;
}

Fan fanOf(const ArrangementResult& result, Index vertex, Index own, const FanCorners& corners) {
  Vec3 way = Vec3::Zero();
  for (const Index c : corners)
    way += result.positions[result.indices[after(c, 1)]] - result.positions[vertex];
  return {vertex, own, corners, way / double(corners.size())};
}

std::vector<Fan> fansToPart(const ArrangementResult& result, const ArrangementInput& input) {
  const std::vector<std::uint8_t> isWanted = verticesOfCuts(result, input);
  const std::vector<Pair> all = cornersOf(result.indices, isWanted);
  const std::vector<Pair> given = cornersOf(input.indices, isWanted);
  std::vector<Fan> toPart;
  for (std::span<const Pair> left = all; !left.empty();) {
    const std::span<const Pair> around = firstOf(left);
    left = left.subspan(around.size());
    const Index vertex = around[0].first;
    const std::vector<FanCorners> fans = fansOf(result.indices, around);
    if (fans.size() < 2 || !isFold(result, input, around)) continue;
    const auto before = std::lower_bound(given.begin(), given.end(), Pair{vertex, 0});
    const auto first = std::size_t(before - given.begin());
    if (fansOf(input.indices, firstOf(std::span(given).subspan(first))).size() != 1) continue;
    std::size_t largest = 0;
    for (std::size_t i = 1; i < fans.size(); ++i)
      if (fans[i].size() > fans[largest].size()) largest = i;
    for (std::size_t i = 0; i < fans.size(); ++i)
      if (i != largest)
        toPart.push_back(
            fanOf(result, vertex, Index(result.positions.size() + toPart.size()), fans[i]));
  }
  return toPart;
}

// At a share of 0 the fan is as it was.
void place(ArrangementResult& result, const ArrangementResult& before, const Fan& fan, double share,
           const PartRule& rule) {
  result.positions[fan.own] = rule.rounded(result.positions[fan.vertex] + share * fan.way);
  for (const Index c : fan.corners) {
    result.indices[c] = share > 0 ? fan.own : fan.vertex;
    const Index t = c / 3;
    const auto own = result.indices.begin() + std::ptrdiff_t{3} * t;
    result.triangles[t].isUntouched =
        before.triangles[t].isUntouched &&
        std::equal(own, own + 3, before.indices.begin() + std::ptrdiff_t{3} * t);
  }
}

bool isClear(const ArrangementResult& result, const Fan& fan) {
  if (result.positions[fan.own] == result.positions[fan.vertex]) return false;
  const std::vector<Index>& met = result.selfIntersections;
  for (const Index c : fan.corners)
    if (std::binary_search(met.begin(), met.end(), c / 3)) return false;
  return true;
}

}  // namespace

void partFans(ArrangementResult& result, const ArrangementInput& input, const PartRule& rule) {
  std::vector<Fan> fans = fansToPart(result, input);
  if (fans.empty()) return;
  fires("arrangement: fans around a corner parted");
  const ArrangementResult before = result;
  result.positions.resize(result.positions.size() + fans.size());
  std::size_t left = fans.size();
  for (const double share : kShares) {
    if (left == 0) break;
    for (const Fan& fan : fans)
      if (!fan.isParted) place(result, before, fan, share, rule);
    result.selfIntersections = rule.crossings(result);
    left = 0;
    for (Fan& fan : fans) left += !(fan.isParted = share > 0 && isClear(result, fan));
  }
  if (left == fans.size() || result.selfIntersections.size() > before.selfIntersections.size())
    result = before;
}

}  // namespace remesher
