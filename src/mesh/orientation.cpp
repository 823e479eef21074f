// SPDX-License-Identifier: MIT
#include "mesh/orientation.h"

#include <algorithm>

namespace remesher {

namespace {

// Two triangles at an edge agree if they run along the edge in opposite directions.
bool agree(std::span<const Index> corners, Index h, Index other) {
  return corners[h] != corners[other];
}

bool allAgree(std::span<const Index> corners, const EdgeGroups& edges) {
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (edges[e].size() == 2 && !agree(corners, edges[e][0], edges[e][1])) return false;
  return true;
}

// Per halfedge its twin, if the edge has exactly two triangles.
std::vector<Index> acrossPlainEdges(std::size_t count, const EdgeGroups& edges) {
  std::vector<Index> across(count, kNone);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges[e].size() != 2) continue;
    across[edges[e][0]] = edges[e][1];
    across[edges[e][1]] = edges[e][0];
  }
  return across;
}

// Floods from one triangle and decides for each triangle reached whether to turn it over. Returns
// the triangles reached. Edges at which the triangles agree are crossed first: a surface of one
// side is cut where its file turns over, and not where two floods happen to meet.
std::vector<Index> flood(std::span<const Index> corners, std::span<const Index> across, Index seed,
                         std::vector<char>& turn) {
  std::vector<Index> reached = {seed}, disagreeing;
  turn[seed] = 0;
  const auto reach = [&](Index h, char turned) {
    turn[across[h] / 3] = turned;
    reached.push_back(across[h] / 3);
  };
  for (std::size_t i = 0, k = 0; i < reached.size(); ++i) {
    for (Index h = 3 * reached[i]; h < 3 * reached[i] + 3; ++h) {
      if (across[h] == kNone || turn[across[h] / 3] >= 0) continue;
      if (agree(corners, h, across[h]))
        reach(h, turn[reached[i]]);
      else
        disagreeing.push_back(h);
    }
    for (; i + 1 == reached.size() && k < disagreeing.size(); ++k)
      if (const Index h = disagreeing[k]; turn[across[h] / 3] < 0) reach(h, char(!turn[h / 3]));
  }
  return reached;
}

}  // namespace

Orientation orient(std::span<const Index> corners, const EdgeGroups& edges) {
  Orientation result;
  if (allAgree(corners, edges)) return result;
  const std::vector<Index> across = acrossPlainEdges(corners.size(), edges);
  result.turn.assign(corners.size() / 3, -1);  // undecided
  for (Index f = 0; f < result.turn.size(); ++f) {
    if (result.turn[f] >= 0) continue;
    const std::vector<Index> region = flood(corners, across, f, result.turn);
    std::size_t turned = 0;
    for (const Index g : region) turned += result.turn[g];
    if (2 * turned > region.size()) {
      for (const Index g : region) result.turn[g] = !result.turn[g];
      turned = region.size() - turned;
    }
    result.turned += turned;
  }
  for (Index h = 0; h < corners.size(); ++h) {
    if (across[h] == kNone || across[h] < h) continue;
    const bool bothOrNone = result.turn[h / 3] == result.turn[across[h] / 3];
    if (agree(corners, h, across[h]) == bothOrNone) continue;
    if (result.conflicts++ == 0) result.conflict = h;
  }
  return result;
}

}  // namespace remesher
