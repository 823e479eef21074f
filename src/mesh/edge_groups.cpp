// SPDX-License-Identifier: MIT
#include "mesh/edge_groups.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/sort_pairs.h"
#include "mesh/halfedge_mesh.h"

namespace remesher {

namespace {

// Edges are visited in so few ranges: each takes a pass over all corners.
constexpr std::size_t kMostRanges = 10;

// The edge's vertex with the larger number, and the halfedge.
using Entry = std::pair<Index, Index>;

// Counting sort of the halfedges by the vertex with the smaller number, for a range of these
// vertices at a time.
class Buckets {
 public:
  Buckets(std::size_t vertexCount, std::span<const Index> corners, Index perFace)
      : corners_(corners), perFace_(perFace), starts_(vertexCount + 1, 0) {
    for (Index h = 0; h < corners.size(); ++h) ++starts_[lower(h) + 1];
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
  }

  // The end of the range from a vertex on that has so many halfedges, or one vertex.
  std::size_t endOfRange(std::size_t from, std::size_t most) const {
    std::size_t to = from + 1;
    while (to + 1 < starts_.size() && starts_[to + 1] - starts_[from] <= most) ++to;
    return to;
  }

  void gather(std::size_t from, std::size_t to) {
    from_ = from, to_ = to;
    entries_.resize(starts_[to] - starts_[from]);
    std::vector<Index> at(starts_.begin() + std::ptrdiff_t(from),
                          starts_.begin() + std::ptrdiff_t(to));
    for (Index h = 0; h < corners_.size(); ++h) {
      const Index v = lower(h);
      if (v < from || v >= to) continue;
      entries_[at[v - from]++ - starts_[from]] = {std::max(corners_[h], tip(h)), h};
    }
  }

  // Visits the range's edges, in the order of their vertices.
  void forEachEdge(const std::function<void(std::span<const Index>)>& visit) {
    std::vector<Index> edge;
    for (std::size_t v = from_; v < to_; ++v) {
      const std::span<Entry> bucket =
          std::span(entries_).subspan(starts_[v] - starts_[from_], starts_[v + 1] - starts_[v]);
      sortPairs(bucket);
      for (std::size_t i = 0; i < bucket.size(); ++i) {
        edge.push_back(bucket[i].second);
        if (i + 1 < bucket.size() && bucket[i + 1].first == bucket[i].first) continue;
        visit(edge);
        edge.clear();
      }
    }
  }

 private:
  Index tip(Index h) const { return corners_[(h + 1) % perFace_ == 0 ? h + 1 - perFace_ : h + 1]; }
  Index lower(Index h) const { return std::min(corners_[h], tip(h)); }

  std::span<const Index> corners_;
  Index perFace_;
  std::vector<Index> starts_;  // per vertex, and the end
  std::size_t from_ = 0, to_ = 0;
  std::vector<Entry> entries_;  // of the range
};

// A list per lower vertex of its edges, each named by its first halfedge.
struct EdgeLists {
  struct Edge {
    Index upper, halfedge, next;
  };

  EdgeLists(std::size_t vertexCount, std::size_t halfedges) : heads(vertexCount, kNone) {
    edges.reserve(halfedges / 2);
  }

  // The edge's first halfedge: the given one if the edge is new; kNone if the list is too long to
  // search.
  Index firstOf(Index lower, Index upper, Index halfedge) {
    int passed = 0;
    Index at = heads[lower];
    for (; at != kNone && edges[at].upper != upper; at = edges[at].next)
      if (++passed > HalfedgeMesh::kMostNeighbors) return kNone;
    if (at != kNone) return edges[at].halfedge;
    edges.push_back({upper, halfedge, heads[lower]});
    heads[lower] = Index(edges.size() - 1);
    return halfedge;
  }

  std::vector<Index> heads;
  std::vector<Edge> edges;
};

}  // namespace

std::vector<Index> plainTwins(std::size_t vertexCount, std::span<const Index> corners) {
  EdgeLists lists(vertexCount, corners.size());
  std::vector<Index> twins(corners.size(), kNone);
  for (Index h = 0; h < corners.size(); ++h) {
    const Index from = corners[h], to = corners[nextCorner(h)];
    const Index first = lists.firstOf(std::min(from, to), std::max(from, to), h);
    if (first == h) continue;
    if (first == kNone || twins[first] != kNone || corners[first] == from) return {};
    twins[h] = first;
    twins[first] = h;
  }
  return twins;
}

EdgeGroups::EdgeGroups(std::size_t vertexCount, std::span<const Index> corners, Index perFace) {
  Buckets buckets(vertexCount, corners, perFace);
  buckets.gather(0, vertexCount);
  halfedges_.reserve(corners.size());
  starts_.reserve(corners.size() / 2 + 2);
  buckets.forEachEdge([&](std::span<const Index> edge) {
    starts_.push_back(Index(halfedges_.size()));
    halfedges_.insert(halfedges_.end(), edge.begin(), edge.end());
  });
  starts_.push_back(Index(halfedges_.size()));
}

void forEachEdgeOf(std::size_t vertexCount, std::span<const Index> corners,
                   const std::function<void(std::span<const Index>)>& visit, std::size_t atOnce) {
  Buckets buckets(vertexCount, corners, 3);
  const std::size_t most = std::max(atOnce, corners.size() / kMostRanges);
  for (std::size_t from = 0, to = 0; from < vertexCount; from = to) {
    to = buckets.endOfRange(from, most);
    buckets.gather(from, to);
    buckets.forEachEdge(visit);
  }
}

}  // namespace remesher
