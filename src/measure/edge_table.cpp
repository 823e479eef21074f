// SPDX-License-Identifier: MIT
#include "measure/edge_table.h"

#include <algorithm>

#include "base/place.h"
#include "base/sort_pairs.h"

namespace remesher {

WeldedMesh weld(const TriangleMesh& mesh) {
  const std::vector<Index> first = weld(mesh.positions);
  std::vector<Index> numbers(mesh.positions.size(), kNone);
  WeldedMesh result;
  result.indices.reserve(mesh.indices.size());
  for (const Index v : mesh.indices) {
    Index& number = numbers[first[v]];
    if (number == kNone) {
      number = static_cast<Index>(result.positions.size());
      result.positions.push_back(mesh.positions[v]);
    }
    result.indices.push_back(number);
  }
  return result;
}

bool hasDistinctVertices(const std::array<Index, 3>& t) {
  return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
}

EdgeTable::EdgeTable(const WeldedMesh& mesh) {
  const auto forEachSide = [&mesh](auto&& visit) {
    for (Index t = 0; t < mesh.triangleCount(); ++t) {
      const std::array<Index, 3> v = mesh.triangle(t);
      if (!hasDistinctVertices(v)) continue;
      for (Index k = 0; k < 3; ++k) {
        const Index a = v[(k + 1) % 3], b = v[(k + 2) % 3];
        visit(std::min(a, b), std::max(a, b), 3 * t + k);
      }
    }
  };
  // A counting sort by the lower vertex, then a sort of each vertex's sides, as a rule six, by the
  // higher one.
  std::vector<Index> bucket(mesh.positions.size() + 1, 0);
  forEachSide([&](Index low, Index, Index) { ++bucket[low + 1]; });
  for (std::size_t v = 1; v < bucket.size(); ++v) bucket[v] += bucket[v - 1];
  std::vector<Side> sides(bucket.back());
  std::vector<Index> next(bucket.begin(), bucket.end() - 1);
  forEachSide([&](Index low, Index high, Index corner) { sides[next[low]++] = {high, corner}; });

  corners_.reserve(sides.size());
  for (std::vector<Index>* const list : {&lows_, &highs_, &begins_})
    list->reserve(sides.size() / 2 + 1);
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    const std::span<Side> own = std::span(sides).subspan(bucket[v], bucket[v + 1] - bucket[v]);
    sortPairs(own);
    for (std::size_t i = 0; i < own.size(); ++i) {
      if (i == 0 || own[i].first != own[i - 1].first) {
        lows_.push_back(v);
        highs_.push_back(own[i].first);
        begins_.push_back(static_cast<Index>(corners_.size()));
      }
      corners_.push_back(own[i].second);
    }
  }
  begins_.push_back(static_cast<Index>(corners_.size()));
}

EdgeTable::Edge EdgeTable::operator[](std::size_t e) const {
  return {lows_[e], highs_[e],
          std::span(corners_).subspan(begins_[e], begins_[e + 1] - begins_[e])};
}

}  // namespace remesher
