// SPDX-License-Identifier: MIT
#include "mesh/edge_groups.h"

#include <algorithm>

namespace remesher {

namespace {

struct Entry {
  Index upper;  // the edge's vertex with the larger number
  Index halfedge;
  bool operator<(const Entry& other) const {
    return upper != other.upper ? upper < other.upper : halfedge < other.halfedge;
  }
};

// Counting sort of the halfedges by the vertex with the smaller number; `starts` gets one entry per
// vertex and the end.
struct Buckets {
  Buckets(std::size_t vertexCount, std::span<const Index> corners)
      : starts(vertexCount + 1, 0), entries(corners.size()) {
    const auto lower = [&](Index h) { return std::min(corners[h], corners[nextCorner(h)]); };
    for (Index h = 0; h < corners.size(); ++h) ++starts[lower(h)];
    Index sum = 0;
    for (Index& start : starts) start = sum += start;
    for (Index h = Index(corners.size()); h-- > 0;)
      entries[--starts[lower(h)]] = {std::max(corners[h], corners[nextCorner(h)]), h};
  }

  std::vector<Index> starts;
  std::vector<Entry> entries;
};

// Buckets hold three entries on average.
void insertionSort(std::span<Entry> bucket) {
  for (std::size_t i = 1; i < bucket.size(); ++i) {
    const Entry entry = bucket[i];
    std::size_t j = i;
    for (; j > 0 && entry < bucket[j - 1]; --j) bucket[j] = bucket[j - 1];
    bucket[j] = entry;
  }
}

}  // namespace

EdgeGroups::EdgeGroups(std::size_t vertexCount, std::span<const Index> corners) {
  constexpr std::size_t kSmall = 16;
  Buckets buckets(vertexCount, corners);
  halfedges_.resize(corners.size());
  starts_.reserve(corners.size() / 2 + 2);
  Index at = 0;
  for (std::size_t v = 0; v < vertexCount; ++v) {
    const std::span<Entry> bucket =
        std::span(buckets.entries)
            .subspan(buckets.starts[v], buckets.starts[v + 1] - buckets.starts[v]);
    if (bucket.size() <= kSmall)
      insertionSort(bucket);
    else
      std::sort(bucket.begin(), bucket.end());
    for (std::size_t i = 0; i < bucket.size(); ++i) {
      if (i == 0 || bucket[i].upper != bucket[i - 1].upper) starts_.push_back(at);
      halfedges_[at++] = bucket[i].halfedge;
    }
  }
  starts_.push_back(at);
}

}  // namespace remesher
