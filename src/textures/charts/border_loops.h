// SPDX-License-Identifier: MIT
// The border of a set of triangles as loops, with the triangles on the left.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "base/types.h"
#include "mesh/edge_groups.h"

namespace remesher {

// Each loop is a list of corners whose edges follow each other. edges: the corners that are
// `isBorder`, in any order; twins: per corner the corner across the edge that begins at it.
template <class IsBorder>
std::vector<std::vector<Index>> borderLoops(std::vector<Index> edges, std::span<const Index> twins,
                                            const IsBorder& isBorder) {
  const auto onwards = [&](Index h) {
    h = nextCorner(h);
    while (!isBorder(h)) h = nextCorner(twins[h]);
    return h;
  };
  std::sort(edges.begin(), edges.end());
  std::vector<char> seen(edges.size(), 0);
  std::vector<std::vector<Index>> loops;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (seen[i]) continue;
    loops.emplace_back();
    for (Index h = edges[i];; h = onwards(h)) {
      const auto at = std::lower_bound(edges.begin(), edges.end(), h) - edges.begin();
      if (seen[at]) break;
      seen[at] = 1;
      loops.back().push_back(h);
    }
  }
  return loops;
}

}  // namespace remesher
