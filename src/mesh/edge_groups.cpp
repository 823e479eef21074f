// SPDX-License-Identifier: MIT
#include "mesh/edge_groups.h"

#include <algorithm>
#include <utility>

#include "base/sort_pairs.h"
#include "mesh/halfedge_mesh.h"

namespace remesher {

namespace {

// The edge's vertex with the larger number, and the halfedge.
using Entry = std::pair<Index, Index>;

// Counting sort of the halfedges by the vertex with the smaller number; `starts` gets one entry per
// vertex and the end.
struct Buckets {
  Buckets(std::size_t vertexCount, std::span<const Index> corners, Index perFace)
      : starts(vertexCount + 1, 0), entries(corners.size()) {
    const auto tip = [&](Index h) {
      return corners[(h + 1) % perFace == 0 ? h + 1 - perFace : h + 1];
    };
    const auto lower = [&](Index h) { return std::min(corners[h], tip(h)); };
    for (Index h = 0; h < corners.size(); ++h) ++starts[lower(h)];
    Index sum = 0;
    for (Index& start : starts) start = sum += start;
    for (Index h = Index(corners.size()); h-- > 0;)
      entries[--starts[lower(h)]] = {std::max(corners[h], tip(h)), h};
  }

  std::vector<Index> starts;
  std::vector<Entry> entries;
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
  halfedges_.resize(corners.size());
  starts_.reserve(corners.size() / 2 + 2);
  Index at = 0;
  for (std::size_t v = 0; v < vertexCount; ++v) {
    const std::span<Entry> bucket =
        std::span(buckets.entries)
            .subspan(buckets.starts[v], buckets.starts[v + 1] - buckets.starts[v]);
    sortPairs(bucket);
    for (std::size_t i = 0; i < bucket.size(); ++i) {
      if (i == 0 || bucket[i].first != bucket[i - 1].first) starts_.push_back(at);
      halfedges_[at++] = bucket[i].second;
    }
  }
  starts_.push_back(at);
}

}  // namespace remesher
