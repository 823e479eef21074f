// SPDX-License-Identifier: MIT
#include "mesh/fan_cut.h"

#include <utility>

#include "mesh/edge_groups.h"

namespace remesher {

namespace {

// Gives the fan of corner h the vertex v, both ways around from h.
void labelFan(std::span<const Index> mates, Index h, Index v, std::vector<Index>& label) {
  Index k = h;
  do {
    label[k] = v;
    k = mates[prevCorner(k)];
  } while (k != kNone && k != h);
  if (k == h) return;
  for (k = mates[h]; k != kNone; k = mates[k]) {
    k = nextCorner(k);
    label[k] = v;
  }
}

}  // namespace

// The first fan at a vertex takes the vertex's place in the order, further fans follow at the end.
void splitFans(std::span<const Index> corners, std::size_t vertexCount,
               std::span<const Index> mates, ManifoldCut& cut) {
  std::vector<Index> firstCopy(vertexCount, kNone);
  for (const Index v : corners) firstCopy[v] = 0;
  cut.origins.clear();
  for (Index v = 0; v < firstCopy.size(); ++v) {
    if (firstCopy[v] == kNone) continue;
    firstCopy[v] = Index(cut.origins.size());
    cut.origins.push_back(v);
  }
  std::vector<char> taken(cut.origins.size(), 0);
  cut.corners.assign(corners.size(), kNone);
  for (Index h = 0; h < corners.size(); ++h) {
    if (cut.corners[h] != kNone) continue;
    Index v = firstCopy[corners[h]];
    if (taken[v]) {
      v = Index(cut.origins.size());
      cut.origins.push_back(corners[h]);
    } else {
      taken[v] = 1;
    }
    labelFan(mates, h, v, cut.corners);
  }
}

void countVertices(std::vector<char> counted, ManifoldCut& cut) {
  std::vector<char> seen(counted.size(), 0);
  for (const Index v : cut.origins) {
    if (seen[v] && !counted[v]) {
      counted[v] = 1;
      ++cut.vertices;
    }
    seen[v] = 1;
  }
}

ManifoldCut cutFans(std::span<const Index> corners, std::size_t vertexCount,
                    std::vector<Index> twins) {
  ManifoldCut cut;
  splitFans(corners, vertexCount, twins, cut);
  countVertices(std::vector<char>(vertexCount, 0), cut);
  cut.twins = std::move(twins);
  return cut;
}

}  // namespace remesher
